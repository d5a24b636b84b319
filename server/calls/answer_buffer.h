// Memory that the kernels write and gRPC sends, without a copy in between.
//
// A grpc::Slice of its own making would keep fewer than 24 bytes inside itself, where they move
// with it and are not aligned for floats. Thread safety: plain values.
#pragma once

#include <grpcpp/support/slice.h>

#include <cstddef>
#include <optional>
#include <string>

#include "gonio/base/result.h"

namespace gonio::server {

struct AnswerBuffer {
  void* data = nullptr;  // aligned to 64 bytes; lives as long as a copy of `slice`
  grpc::Slice slice;

  // Uninitialised; nothing if there is no memory.
  static std::optional<AnswerBuffer> allocate(std::size_t bytes);
};

// The error where allocate() had none. `what`: such as "5 pairs".
inline Error no_memory_for(const std::string& what) {
  return {ErrorCode::resource_exhausted, "no memory for " + what, "", "", ""};
}

}  // namespace gonio::server
