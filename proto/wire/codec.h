// The hot path's codec: the requests and responses of Evaluate and Sample straight from and into
// gRPC's slices, so that the large arrays are never copied into a message. What is written is plain
// protobuf; what is read may be any legal protobuf of these messages (the canonical form is fast,
// anything else goes through the generated parser first).
//
// Thread safety: functions without state, plain values.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/slice.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "gonio/base/result.h"
#include "gonio/v1/evaluate.pb.h"
#include "gonio/v1/sample.pb.h"
#include "wire/bytes.h"

namespace gonio::wire {

// An array that still lies in the message: `count` elements from byte `offset` on.
struct Array {
  std::size_t offset = 0;
  std::size_t count = 0;
};

// In all requests: the serialised gonio.v1.Material, not parsed (a caller that has seen the same
// bytes before need not parse them), and the places of the arrays.
struct Request {
  using Message = gonio::v1::EvaluateRequest;
  enum class Kind : std::uint8_t { none, pairs, pairs_f64, grid };
  Message head;  // everything but the material and the pairs
  std::optional<std::string> material;
  Kind kind = Kind::none;
  SliceBytes bytes;
  Array wi, wo;  // in floats (pairs) or doubles (pairs_f64), 3 per direction; lengths unchecked
};

struct SampleRequest {
  using Message = gonio::v1::SampleRequest;
  Message head;  // everything but the material and the arrays
  std::optional<std::string> material;
  SliceBytes bytes;
  Array wi, wi_f64, xi, xi_f64;  // in floats or doubles; lengths unchecked
};

struct IntegrateRequest {
  using Message = gonio::v1::IntegrateRequest;
  Message head;  // everything but the material and the arrays
  std::optional<std::string> material;
  SliceBytes bytes;
  Array wi, wi_f64;  // as above
};

// The chunk of a stream: of EvaluateStreamRequest or SampleStreamRequest.
template <class R>
struct ChunkOf {
  std::uint64_t sequence = 0;
  std::uint32_t slot = 0;
  Result<R> request = R{};  // an error of this chunk alone
};
using StreamRequest = ChunkOf<Request>;
using SampleStreamRequest = ChunkOf<SampleRequest>;

template <class Head>
struct ResponseOf {
  using Message = Head;
  Head head;            // everything but the arrays
  SliceBytes bytes;     // what the arrays lie in
  Array flags;          // bytes; none if nothing is flagged
  Array values;         // a sample's are its weights
  Array pdf;            // none if not asked for
  Array wo;             // of samples
  bool is_f64 = false;  // whether values, pdf and wo are doubles
};
using Response = ResponseOf<gonio::v1::EvaluateResponse>;
using SampleResponse = ResponseOf<gonio::v1::SampleResponse>;

// The answer to a chunk.
template <class R>
struct ChunkAnswerOf {
  std::uint64_t sequence = 0;
  std::variant<R, gonio::v1::ErrorDetail> result;
};
using StreamResponse = ChunkAnswerOf<Response>;
using SampleStreamResponse = ChunkAnswerOf<SampleResponse>;

// Reads any of the types above. Errors: invalid_argument for bytes that are not such a message, or
// whose material would have to be parsed here and is larger than kMaxMaterialBytes.
template <class Decoded>
Result<Decoded> decode(const grpc::ByteBuffer& buffer);

// Arrays for a request: slices of 3 floats (or doubles) per direction or sample, interleaved.
// borrow() makes one without a copy.
struct PairSlices {
  grpc::Slice wi, wo;
  bool is_f64 = false;
};
struct SampleSlices {
  grpc::Slice wi, xi;  // xi may be empty
  bool is_f64 = false;
};

// The arrays of a request as fields of its message.
struct RequestArrays {
  RequestArrays() = default;
  // NOLINTBEGIN(google-explicit-constructor): one of these is what a request's arrays are
  RequestArrays(const PairSlices& pairs);
  RequestArrays(const SampleSlices& samples);
  // NOLINTEND(google-explicit-constructor)

  struct One {
    std::uint32_t number = 0;  // of the field; 0: there is none
    grpc::Slice data;
  };
  std::uint32_t within = 0;  // the field of the request that holds them; 0: the request itself
  std::array<One, 2> arrays;
};

// `head` is the serialised request without these arrays, which need not be put together for every
// batch.
grpc::ByteBuffer encode_request(std::string_view head, const RequestArrays& arrays);
grpc::ByteBuffer encode_stream_request(std::uint64_t sequence, std::uint32_t slot,
                                       std::string_view head, const RequestArrays& arrays);

// `head` without the arrays; those may be empty. Their type is that of the values.
template <class Head>
struct ResponsePartsOf {
  Head head;
  grpc::Slice flags, values, pdf, wo;
  bool is_f64 = false;
};
using ResponseParts = ResponsePartsOf<gonio::v1::EvaluateResponse>;
using SampleResponseParts = ResponsePartsOf<gonio::v1::SampleResponse>;

template <class Head>
grpc::ByteBuffer encode_response(const ResponsePartsOf<Head>& parts);
grpc::ByteBuffer encode_response(const gonio::v1::IntegrateResponse& response);
template <class Head>
grpc::ByteBuffer encode_stream_response(std::uint64_t sequence, const ResponsePartsOf<Head>& parts);
grpc::ByteBuffer encode_stream_error(std::uint64_t sequence, const gonio::v1::ErrorDetail& error);

// A slice of the caller's memory, which must stay valid and unchanged until the slice's last copy
// is gone: gRPC may hold one beyond the end of a cancelled call.
template <class T>
grpc::Slice borrow(std::span<const T> data) {
  return {data.data(), data.size_bytes(), grpc::Slice::STATIC_SLICE};
}

}  // namespace gonio::wire
