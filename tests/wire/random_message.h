// Messages with something in every field. Thread safety: plain values.
#pragma once

#include <google/protobuf/message.h>

#include <random>
#include <stdexcept>
#include <string>

namespace gonio::wire {

// Fills every field with what is not its default: numbers and texts at random, three of each list,
// of a oneof the first field or the last. Parameters of materials are left out.
class RandomMessage {
 public:
  explicit RandomMessage(unsigned seed) : random_(seed) {}

  void fill(google::protobuf::Message& message) {
    const auto& descriptor = *message.GetDescriptor();
    for (int i = 0; i < descriptor.field_count(); ++i) {
      const auto& field = *descriptor.field(i);
      if (field.real_containing_oneof() == nullptr) fill(message, field);
    }
    for (int i = 0; i < descriptor.real_oneof_decl_count(); ++i) {
      const auto& choice = *descriptor.oneof_decl(i);
      fill(message, *choice.field(up_to(1) == 0 ? 0 : choice.field_count() - 1));
    }
  }

 private:
  using FieldDescriptor = google::protobuf::FieldDescriptor;

  // A material's parameters: of any depth, and read as a whole.
  static bool is_any_json(const FieldDescriptor& field) {
    return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE &&
           field.message_type()->file()->package() == "google.protobuf";
  }

  int up_to(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  double number() { return std::uniform_real_distribution<double>(-2, 2)(random_) + 4; }
  std::string text() { return "text " + std::to_string(up_to(1'000'000)); }

  void fill(google::protobuf::Message& message, const FieldDescriptor& field) {
    constexpr int kEach = 3;
    if (is_any_json(field)) return;
    if (!field.is_repeated()) return set(message, field);
    for (int i = 0; i < kEach; ++i) add(message, field);
  }

  void set(google::protobuf::Message& message, const FieldDescriptor& field) {
    const auto& to = *message.GetReflection();
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_DOUBLE:
        return to.SetDouble(&message, &field, number());
      case FieldDescriptor::CPPTYPE_BOOL:
        return to.SetBool(&message, &field, true);
      case FieldDescriptor::CPPTYPE_STRING:
        return to.SetString(&message, &field, text());
      case FieldDescriptor::CPPTYPE_INT32:
        return to.SetInt32(&message, &field, 1 + up_to(1'000'000));
      case FieldDescriptor::CPPTYPE_UINT32:
        return to.SetUInt32(&message, &field, 1U + static_cast<unsigned>(up_to(1'000'000)));
      case FieldDescriptor::CPPTYPE_UINT64:
        return to.SetUInt64(&message, &field, (1ULL << 40U) + static_cast<unsigned>(up_to(1'000)));
      case FieldDescriptor::CPPTYPE_ENUM:
        return to.SetEnumValue(&message, &field, 1 + up_to(field.enum_type()->value_count() - 2));
      case FieldDescriptor::CPPTYPE_MESSAGE:
        return fill(*to.MutableMessage(&message, &field));
      default:
        throw std::logic_error("no structure has such a field: " + field.full_name());
    }
  }

  void add(google::protobuf::Message& message, const FieldDescriptor& field) {
    const auto& to = *message.GetReflection();
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_DOUBLE:
        return to.AddDouble(&message, &field, number());
      case FieldDescriptor::CPPTYPE_STRING:
        return to.AddString(&message, &field, text());
      case FieldDescriptor::CPPTYPE_MESSAGE:
        return fill(*to.AddMessage(&message, &field));
      default:
        throw std::logic_error("no structure has such a list: " + field.full_name());
    }
  }

  std::mt19937 random_;
};

}  // namespace gonio::wire
