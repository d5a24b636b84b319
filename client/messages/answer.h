// What the answers of Evaluate and of Sample have in common, and how each is asked for. Internal to
// the client library.
//
// Thread safety: plain values, functions without state.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <cstdint>
#include <variant>

#include "gonio/base/result.h"
#include "wire/codec.h"

namespace gonio::client {

struct Answer {
  std::size_t channels = 0;
  gonio::v1::Report report;
  std::uint64_t lost = 0;
  wire::SliceBytes bytes;  // where the arrays lie
  wire::Array flags, values, pdf, wo;
  bool is_f64 = false;
};

struct StreamAnswer {
  std::uint64_t sequence = 0;
  std::variant<Answer, gonio::v1::ErrorDetail> result;
};

struct Method {
  const char* call;
  const char* stream;
  Result<Answer> (*decode)(const grpc::ByteBuffer& message);
  Result<StreamAnswer> (*decode_stream)(const grpc::ByteBuffer& message);
};
extern const Method kEvaluate, kSample;

}  // namespace gonio::client
