// Requests in which every option is given. Thread safety: functions without state.
#pragma once

#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <array>

#include "gonio/client/fit.h"

namespace gonio::test {

// Every field that is not of a oneof, in the message's own messages too.
inline void expect_all_set(const google::protobuf::Message& message) {
  const auto& reflection = *message.GetReflection();
  const auto& descriptor = *message.GetDescriptor();
  for (int i = 0; i < descriptor.field_count(); ++i) {
    const auto& field = *descriptor.field(i);
    if (field.real_containing_oneof() != nullptr) continue;
    const bool set = field.is_repeated() ? reflection.FieldSize(message, &field) > 0
                                         : reflection.HasField(message, &field);
    EXPECT_TRUE(set) << field.full_name();
    const bool of_messages = field.cpp_type() == field.CPPTYPE_MESSAGE && !field.is_map();
    if (!set || !of_messages || field.message_type()->name() == "Material") continue;
    expect_all_set(field.is_repeated() ? reflection.GetRepeatedMessage(message, &field, 0)
                                       : reflection.GetMessage(message, &field));
  }
}

inline constexpr std::array<float, 3> kUp{0, 0, 1}, kValue{0.1F, 0.2F, 0.3F};
inline client::FitData one_pair() { return {kUp, kUp, kValue, 3, {}, {}}; }

}  // namespace gonio::test
