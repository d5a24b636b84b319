// Helpers of the wire tests: messages to and from buffers, cut into slices of chosen sizes.
#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/support/byte_buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "wire/codec.h"

namespace gonio::wire::testing {

// The bytes as one buffer, in slices of at most `slice` bytes.
inline grpc::ByteBuffer buffer_of(const std::string& bytes, std::size_t slice = SIZE_MAX) {
  std::vector<grpc::Slice> slices;
  for (std::size_t at = 0; at < bytes.size(); at += std::min(slice, bytes.size() - at)) {
    slices.emplace_back(bytes.data() + at, std::min(slice, bytes.size() - at));
  }
  return {slices.data(), slices.size()};
}

inline std::string text_of(const grpc::ByteBuffer& buffer) {
  const SliceBytes bytes = SliceBytes::of(buffer);
  return bytes.text(0, bytes.size());
}

template <class T>
std::vector<T> elements(const SliceBytes& bytes, const Array& array) {
  std::vector<T> values(array.count);
  bytes.copy(array.offset, array.count * sizeof(T), values.data());
  return values;
}

template <class T>
grpc::Slice slice_of(const std::vector<T>& values) {
  return {values.data(), values.size() * sizeof(T)};
}

inline v1::EvaluateRequest request_head() {
  v1::EvaluateRequest head;
  head.mutable_material()->set_model("ggx");
  (*head.mutable_material()->mutable_parameters()->mutable_fields())["alpha_x"].set_number_value(
      0.25);
  head.set_instruction_set(v1::INSTRUCTION_SET_AVX2);
  return head;
}

inline std::vector<float> random_floats(std::size_t count, std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<float> values(count);
  std::generate(values.begin(), values.end(), [&] { return uniform(random); });
  return values;
}

inline v1::EvaluateRequest request_with_pairs(std::size_t pairs, std::mt19937& random) {
  v1::EvaluateRequest request = request_head();
  const auto wi = random_floats(3 * pairs, random), wo = random_floats(3 * pairs, random);
  request.mutable_pairs()->mutable_wi()->Add(wi.begin(), wi.end());
  request.mutable_pairs()->mutable_wo()->Add(wo.begin(), wo.end());
  return request;
}

}  // namespace gonio::wire::testing
