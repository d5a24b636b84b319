#include "wire/status.h"

#include "gonio/base/shown.h"

namespace gonio::wire {
namespace {

// HTTP/2 headers are limited to 8 KiB by default; a status carries its texts twice, one of them in
// base64 and the other with up to three bytes for each.
constexpr std::size_t kMaxMessage = 800, kMaxField = 200, kMaxValue = 200, kMaxAllowed = 600;

grpc::StatusCode status_code(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
      return grpc::StatusCode::INVALID_ARGUMENT;
    case ErrorCode::not_found:
      return grpc::StatusCode::NOT_FOUND;
    case ErrorCode::already_exists:
      return grpc::StatusCode::ALREADY_EXISTS;
    case ErrorCode::data_loss:
      return grpc::StatusCode::DATA_LOSS;
    case ErrorCode::resource_exhausted:
      return grpc::StatusCode::RESOURCE_EXHAUSTED;
    case ErrorCode::cancelled:
      return grpc::StatusCode::CANCELLED;
    case ErrorCode::deadline_exceeded:
      return grpc::StatusCode::DEADLINE_EXCEEDED;
    case ErrorCode::unavailable:
      return grpc::StatusCode::UNAVAILABLE;
    case ErrorCode::internal:
      return grpc::StatusCode::INTERNAL;
  }
  return grpc::StatusCode::INTERNAL;
}

ErrorCode error_code(int code) {
  switch (code) {
    case grpc::StatusCode::INVALID_ARGUMENT:
    case grpc::StatusCode::OUT_OF_RANGE:
      return ErrorCode::invalid_argument;
    case grpc::StatusCode::NOT_FOUND:
      return ErrorCode::not_found;
    case grpc::StatusCode::ALREADY_EXISTS:
      return ErrorCode::already_exists;
    case grpc::StatusCode::DATA_LOSS:
      return ErrorCode::data_loss;
    case grpc::StatusCode::RESOURCE_EXHAUSTED:
      return ErrorCode::resource_exhausted;
    case grpc::StatusCode::CANCELLED:
      return ErrorCode::cancelled;
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      return ErrorCode::deadline_exceeded;
    case grpc::StatusCode::UNAVAILABLE:
      return ErrorCode::unavailable;
    default:
      return ErrorCode::internal;
  }
}

}  // namespace

std::string shortened(std::string_view text, std::size_t max_bytes) {
  if (text.size() <= max_bytes) return std::string(text);
  constexpr std::string_view kMark = "...";
  std::size_t end = max_bytes > kMark.size() ? max_bytes - kMark.size() : 0;
  // Not in the middle of a character: protobuf refuses broken UTF-8.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return std::string(text.substr(0, end)).append(kMark);
}

namespace {

// Errors quote requests and files, whose bytes need not be UTF-8.
std::string sendable(std::string_view text, std::size_t max_bytes) {
  return shortened(shown(text, max_bytes), max_bytes);
}

}  // namespace

gonio::v1::ErrorDetail to_detail(const Error& error) {
  gonio::v1::ErrorDetail detail;
  detail.set_code(status_code(error.code));
  detail.set_message(sendable(error.message, kMaxMessage));
  detail.set_field(sendable(error.field, kMaxField));
  detail.set_value(sendable(error.value, kMaxValue));
  detail.set_allowed(sendable(error.allowed, kMaxAllowed));
  return detail;
}

Error from_detail(const gonio::v1::ErrorDetail& detail) {
  return {error_code(detail.code()), shown(detail.message()), shown(detail.field()),
          shown(detail.value()), shown(detail.allowed())};
}

grpc::Status to_status(const Error& error) {
  const gonio::v1::ErrorDetail detail = to_detail(error);
  return {status_code(error.code), detail.message(), detail.SerializeAsString()};
}

Error from_status(const grpc::Status& status) {
  gonio::v1::ErrorDetail detail;
  const bool has_detail =
      !status.error_details().empty() && detail.ParseFromString(status.error_details());
  if (has_detail && detail.code() == status.error_code()) return from_detail(detail);
  return {error_code(status.error_code()), shown(status.error_message()), "", "", ""};
}

}  // namespace gonio::wire
