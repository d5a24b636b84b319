// What becomes of a call whose work throws: the call ends, the log says so, the server goes on.
// Thread safety: functions without state.
#pragma once

#include <grpcpp/support/status.h>

#include <exception>

#include "gonio/base/result.h"

namespace spdlog {
class logger;
}

namespace gonio::server {

// The error that ends the call: resource_exhausted where memory was short, else internal. Writes a
// line of the log with the call's `method`, such as "Fit", and what was thrown.
Error error_of_failure(const char* method, const std::exception_ptr& failure,
                       spdlog::logger& logger) noexcept;

// The same as a status.
grpc::Status status_of_failure(const char* method, const std::exception_ptr& failure,
                               spdlog::logger& logger) noexcept;

}  // namespace gonio::server
