#include "server/calls/failure.h"

#include <spdlog/spdlog.h>

#include <new>
#include <string>

#include "server/calls/answer_buffer.h"
#include "wire/status.h"

namespace gonio::server {
namespace {

// What is short enough to need no memory of its own.
constexpr const char* kNoMemory = "out of memory";

std::string words_of(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception of an unknown kind";
  }
}

bool is_shortage(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const std::bad_alloc&) {
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace

Error error_of_failure(const char* method, const std::exception_ptr& failure,
                       spdlog::logger& logger) noexcept {
  try {
    const std::string words = words_of(failure);
    logger.error("{} failed: {}", method, words);
    if (is_shortage(failure)) return no_memory_for(std::string("this call of ") + method);
    return {ErrorCode::internal,
            std::string("the server failed at this call of ") + method + ": " + words, "", "", ""};
  } catch (...) {
    return {ErrorCode::resource_exhausted, kNoMemory, "", "", ""};
  }
}

grpc::Status status_of_failure(const char* method, const std::exception_ptr& failure,
                               spdlog::logger& logger) noexcept {
  const Error error = error_of_failure(method, failure, logger);
  try {
    return wire::to_status(error);
  } catch (...) {
    return {grpc::StatusCode::RESOURCE_EXHAUSTED, kNoMemory};
  }
}

}  // namespace gonio::server
