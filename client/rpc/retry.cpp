#include "client/rpc/retry.h"

#include <algorithm>
#include <charconv>
#include <random>

#include "client/rpc/wait.h"
#include "gonio/base/shown.h"
#include "wire/status.h"

namespace gonio::client {
namespace {

constexpr std::chrono::milliseconds kLongestPause{2000};
// A server that asks for more does not want to be asked again.
constexpr long kLongestPushback = 60'000;
constexpr std::chrono::milliseconds kLongestDeadline = std::chrono::hours(24 * 365);

std::optional<long> pushback_of(const grpc::ClientContext& context) {
  const auto& metadata = context.GetServerTrailingMetadata();
  const auto found = metadata.find(wire::kRetryPushback);
  if (found == metadata.end()) return std::nullopt;
  long milliseconds = -1;  // what cannot be read means "do not", as gRPC's own retries have it
  const char* end = found->second.data() + found->second.size();
  const auto [at, error] = std::from_chars(found->second.data(), end, milliseconds);
  const bool readable = error == std::errc{} && at == end;
  return readable && milliseconds <= kLongestPushback ? milliseconds : -1;
}

// gRPC's own words ("failed to connect to all addresses") need the server's name to be of use.
Error named(const grpc::Status& status, const std::string& peer) {
  Error error = wire::from_status(status);
  if (!status.error_details().empty()) return error;
  switch (status.error_code()) {
    case grpc::StatusCode::UNAVAILABLE:
      error.message = peer + " cannot be reached: " + shown(status.error_message());
      break;
    case grpc::StatusCode::DEADLINE_EXCEEDED:
      error.message = peer + " did not answer within the deadline";
      break;
    default:
      error.message = peer + " answered: " + shown(status.error_message());
  }
  // With a bound it is the request that is too large, and the caller's to change: programs end with
  // another exit status than where a server is too busy. gRPC has no other mark of it than these
  // words, whichever end refuses.
  const bool large = status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED &&
                     status.error_message().find("larger than max") != std::string::npos;
  if (large) {
    error.allowed =
        "fewer pairs or bins in one call; a server takes more with a larger --max-message-mb";
    error.message += "; allowed: " + error.allowed;
  }
  return error;
}

}  // namespace

Failure failure_of(const grpc::Status& status, const grpc::ClientContext& context,
                   const std::string& peer) {
  Failure failure{named(status, peer), false, std::nullopt};
  const bool unavailable = status.error_code() == grpc::StatusCode::UNAVAILABLE;
  const bool exhausted = status.error_code() == grpc::StatusCode::RESOURCE_EXHAUSTED;
  if (!unavailable && !exhausted) return failure;
  const std::optional<long> pushback = pushback_of(context);
  if (pushback.value_or(0) < 0) return failure;
  if (pushback) failure.pushback = std::chrono::milliseconds(*pushback);
  failure.may_retry = unavailable || pushback;
  return failure;
}

Failure failure_of(const gonio::v1::ErrorDetail& detail) {
  Failure failure{wire::from_detail(detail), false, std::nullopt};
  // What has a bound is too large at any time; a queue is full for a moment.
  const bool too_large = !failure.error.allowed.empty();
  failure.may_retry = failure.error.code == ErrorCode::unavailable ||
                      (failure.error.code == ErrorCode::resource_exhausted && !too_large);
  return failure;
}

Patience::Patience(const ClientOptions& options, std::optional<std::chrono::milliseconds> deadline)
    : max_retries_(options.max_retries), backoff_(options.backoff) {
  const std::chrono::milliseconds limit = deadline.value_or(options.deadline);
  // A deadline in the far future must not overflow the clock.
  if (limit.count() > 0) deadline_ = Clock::now() + std::min(limit, kLongestDeadline);
}

std::chrono::milliseconds Patience::next_pause(const Failure& failure) {
  if (failure.pushback) return *failure.pushback;
  const double doubled =
      static_cast<double>(backoff_.count()) * static_cast<double>(1U << std::min(in_vain_, 16));
  const double longest = static_cast<double>(kLongestPause.count());
  std::minstd_rand random(std::random_device{}());  // made here: most calls never need it
  std::uniform_real_distribution<double> jitter(0.8, 1.2);
  return std::chrono::milliseconds(static_cast<long>(std::min(doubled, longest) * jitter(random)));
}

bool Patience::pause_to_retry(const Failure& failure) {
  if (!failure.may_retry || in_vain_ >= max_retries_) return false;
  const auto pause = next_pause(failure);
  if (deadline_ && Clock::now() + pause >= *deadline_) return false;
  wait_until(Clock::now() + pause);
  ++in_vain_;
  ++retries_;
  return true;
}

}  // namespace gonio::client
