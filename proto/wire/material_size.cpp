#include "wire/material_size.h"

#include <string>

#include "wire/numbers.h"

namespace gonio::wire {
namespace {

// The sum of `count` over every field of that number. Everything behind a group counts, because
// only the generated parser can follow groups.
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
  return sum_of(bytes, range, kMaterial, [](Range material) { return material.size(); });
}

std::size_t in_stream_request(const SliceBytes& bytes, Range range) {
  return sum_of(bytes, range, StreamNumbers::kRequest,
                [&](Range request) { return in_request(bytes, request); });
}

}  // namespace

Outcome check_material_size(std::size_t bytes) {
  if (bytes <= kMaxMaterialBytes) return Ok{};
  return bad_value("material", std::to_string(bytes) + " bytes",
                   "at most " + std::to_string(kMaxMaterialBytes) + " bytes");
}

template <class Decoded>
Outcome check_material(const SliceBytes& bytes, Range range) {
  constexpr bool kIsChunk = requires(Decoded d) { d.sequence; };
  return check_material_size(kIsChunk ? in_stream_request(bytes, range) : in_request(bytes, range));
}

template Outcome check_material<Request>(const SliceBytes&, Range);
template Outcome check_material<SampleRequest>(const SliceBytes&, Range);
template Outcome check_material<IntegrateRequest>(const SliceBytes&, Range);
template Outcome check_material<StreamRequest>(const SliceBytes&, Range);
template Outcome check_material<SampleStreamRequest>(const SliceBytes&, Range);

}  // namespace gonio::wire
