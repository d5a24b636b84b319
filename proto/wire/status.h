// Errors on the wire: the one place where a core error becomes a gRPC status, and back.
//
// A status carries the serialised gonio.v1.ErrorDetail as its details (grpc-status-details-bin).
// Texts are shortened so that a status always fits into HTTP/2 headers, and pass through shown()
// (gonio/base/shown.h) on both sides: neither has to trust the other's bytes. Thread safety:
// functions without state.
#pragma once

#include <grpcpp/support/status.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "gonio/base/result.h"
#include "gonio/v1/error.pb.h"

namespace gonio::wire {

gonio::v1::ErrorDetail to_detail(const Error& error);
Error from_detail(const gonio::v1::ErrorDetail& detail);

grpc::Status to_status(const Error& error);
// The details where they are there, else the status's own code and message. `status` must not be
// OK.
Error from_status(const grpc::Status& status);

// At most `max_bytes` bytes of UTF-8 `text`, ending in "..." where something was left out.
std::string shortened(std::string_view text, std::size_t max_bytes);

// Trailing metadata of a refused call: how many milliseconds to wait before the next try.
inline constexpr const char* kRetryPushback = "grpc-retry-pushback-ms";

}  // namespace gonio::wire
