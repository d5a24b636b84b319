#include "wire/material_size.h"

#include <string>

namespace gonio::wire {
namespace {

// The sum of what `count` finds in every field of that number. Behind a group, which only the
// generated parser can follow, all the rest counts: there may be anything.
template <class Count>
std::size_t sum_of(const SliceBytes& bytes, Range range, std::uint32_t number, const Count& count) {
  std::size_t sum = 0, walked = range.begin;
  FieldReader fields(bytes, range);
  for (Field field; fields.next(field); walked = field.whole.end) {
    if (field.is(number, WireType::bytes)) sum += count(field.value);
  }
  return fields.ok() ? sum : sum + (range.end - walked);
}

std::size_t in_request(const SliceBytes& bytes, Range range) {
  return sum_of(bytes, range, gonio::v1::EvaluateRequest::kMaterialFieldNumber,
                [](Range material) { return material.size(); });
}

std::size_t in_stream_request(const SliceBytes& bytes, Range range) {
  return sum_of(bytes, range, gonio::v1::EvaluateStreamRequest::kEvaluateFieldNumber,
                [&](Range request) { return in_request(bytes, request); });
}

}  // namespace

Outcome check_material_size(std::size_t bytes) {
  if (bytes <= kMaxMaterialBytes) return Ok{};
  return bad_value("material", std::to_string(bytes) + " bytes",
                   "at most " + std::to_string(kMaxMaterialBytes) + " bytes");
}

template <>
Outcome check_material<Request>(const SliceBytes& bytes, Range range) {
  return check_material_size(in_request(bytes, range));
}

template <>
Outcome check_material<StreamRequest>(const SliceBytes& bytes, Range range) {
  return check_material_size(in_stream_request(bytes, range));
}

}  // namespace gonio::wire
