// The field numbers that the codec itself writes and reads, and that messages have in common.
// Internal to wire/.
#pragma once

#include <cstdint>

#include "gonio/v1/evaluate.pb.h"
#include "gonio/v1/sample.pb.h"

namespace gonio::wire {

// Of a request: its material.
inline constexpr std::uint32_t kMaterial = gonio::v1::EvaluateRequest::kMaterialFieldNumber;
static_assert(kMaterial == gonio::v1::SampleRequest::kMaterialFieldNumber);
static_assert(kMaterial == gonio::v1::IntegrateRequest::kMaterialFieldNumber);

// Of a stream's messages: the fields that hold requests and answers.
struct StreamNumbers {
  static constexpr std::uint32_t kSequence = 1, kSlot = 2, kRequest = 3;
  static constexpr std::uint32_t kAnswer = 2, kError = 3;
};
template <class Request, class Response>
constexpr bool has_stream_numbers(std::uint32_t request, std::uint32_t answer) {
  using Numbers = StreamNumbers;
  return Request::kSequenceFieldNumber == Numbers::kSequence &&
         Request::kSlotFieldNumber == Numbers::kSlot && request == Numbers::kRequest &&
         Response::kSequenceFieldNumber == Numbers::kSequence && answer == Numbers::kAnswer &&
         Response::kErrorFieldNumber == Numbers::kError;
}
static_assert(
    has_stream_numbers<gonio::v1::EvaluateStreamRequest, gonio::v1::EvaluateStreamResponse>(
        gonio::v1::EvaluateStreamRequest::kEvaluateFieldNumber,
        gonio::v1::EvaluateStreamResponse::kEvaluateFieldNumber));
static_assert(has_stream_numbers<gonio::v1::SampleStreamRequest, gonio::v1::SampleStreamResponse>(
    gonio::v1::SampleStreamRequest::kSampleFieldNumber,
    gonio::v1::SampleStreamResponse::kSampleFieldNumber));

// Of a response: its arrays, in float32 and in float64; 0 for an array that it lacks.
struct ArrayNumbers {
  std::uint32_t flags;
  struct Pair {
    std::uint32_t f32, f64;
    [[nodiscard]] std::uint32_t of(bool is_f64) const { return is_f64 ? f64 : f32; }
  } values, pdf, wo;
};
template <class Message>
constexpr ArrayNumbers array_numbers();
template <>
constexpr ArrayNumbers array_numbers<gonio::v1::EvaluateResponse>() {
  using Wire = gonio::v1::EvaluateResponse;
  return {Wire::kFlagsFieldNumber,
          {Wire::kValuesFieldNumber, Wire::kValuesF64FieldNumber},
          {Wire::kPdfFieldNumber, Wire::kPdfF64FieldNumber},
          {0, 0}};
}
template <>
constexpr ArrayNumbers array_numbers<gonio::v1::SampleResponse>() {
  using Wire = gonio::v1::SampleResponse;
  return {Wire::kFlagsFieldNumber,
          {Wire::kWeightsFieldNumber, Wire::kWeightsF64FieldNumber},
          {Wire::kPdfFieldNumber, Wire::kPdfF64FieldNumber},
          {Wire::kWoFieldNumber, Wire::kWoF64FieldNumber}};
}

}  // namespace gonio::wire
