// The hot path's codec: EvaluateRequest and EvaluateResponse straight from and into gRPC's slices,
// so that the large arrays are never copied into a message. What is written is plain protobuf; what
// is read may be any legal protobuf of these messages (the canonical form is fast, anything else
// goes through the generated parser first).
//
// Thread safety: functions without state, plain values.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/slice.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "base/result.h"
#include "gonio/v1/evaluate.pb.h"
#include "wire/bytes.h"

namespace gonio::wire {

// An array that still lies in the message: `count` elements from byte `offset` on.
struct Array {
  std::size_t offset = 0;
  std::size_t count = 0;
};

struct Request {
  enum class Kind : std::uint8_t { none, pairs, pairs_f64, grid };
  gonio::v1::EvaluateRequest head;  // everything but the material and the pairs
  // The serialised gonio.v1.Material, not parsed: whoever has seen the same bytes before need not.
  std::optional<std::string> material;
  Kind kind = Kind::none;
  SliceBytes bytes;  // where wi and wo lie
  Array wi, wo;      // in floats (pairs) or doubles (pairs_f64), 3 per direction; lengths unchecked
};

struct StreamRequest {
  std::uint64_t sequence = 0;
  std::uint32_t slot = 0;
  Result<Request> request = Request{};  // an error of this chunk alone
};

struct Response {
  gonio::v1::EvaluateResponse head;  // everything but flags and values
  SliceBytes bytes;                  // where flags and values lie
  Array flags;                       // bytes; none if no pair is flagged
  Array values;                      // floats, or doubles
  bool is_f64 = false;               // which of the two
};

struct StreamResponse {
  std::uint64_t sequence = 0;
  std::variant<Response, gonio::v1::ErrorDetail> result;
};

// Errors: invalid_argument for bytes that are not such a message, or whose material would have to
// be parsed here and is larger than kMaxMaterialBytes.
Result<Request> decode_request(const grpc::ByteBuffer& buffer);
Result<StreamRequest> decode_stream_request(const grpc::ByteBuffer& buffer);
Result<Response> decode_response(const grpc::ByteBuffer& buffer);
Result<StreamResponse> decode_stream_response(const grpc::ByteBuffer& buffer);

// Pairs for a request: slices of 3 floats (or doubles) per direction, interleaved. borrow() makes
// one without a copy.
struct PairSlices {
  grpc::Slice wi, wo;
  bool is_f64 = false;
};

// `head` is a serialised EvaluateRequest without pairs, which need not be put together for every
// batch; `pairs` null for a grid (in `head`).
grpc::ByteBuffer encode_request(std::string_view head, const PairSlices* pairs);
grpc::ByteBuffer encode_stream_request(std::uint64_t sequence, std::uint32_t slot,
                                       std::string_view head, const PairSlices* pairs);

// `head` without flags and values; `flags` empty for none.
struct ResponseParts {
  gonio::v1::EvaluateResponse head;
  grpc::Slice flags;
  grpc::Slice values;
  bool is_f64 = false;
};
grpc::ByteBuffer encode_response(const ResponseParts& parts);
grpc::ByteBuffer encode_stream_response(std::uint64_t sequence, const ResponseParts& parts);
grpc::ByteBuffer encode_stream_error(std::uint64_t sequence, const gonio::v1::ErrorDetail& error);

// A slice of the caller's memory, which must stay valid and unchanged until the slice's last copy
// is gone: gRPC may hold one beyond the end of a cancelled call.
template <class T>
grpc::Slice borrow(std::span<const T> data) {
  return {data.data(), data.size_bytes(), grpc::Slice::STATIC_SLICE};
}

}  // namespace gonio::wire
