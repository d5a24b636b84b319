// When to try again: the deadline and the retries of one operation. Internal to the client library.
//
// Thread safety: used by one thread.
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/support/status.h>

#include <chrono>
#include <optional>
#include <string>

#include "gonio/base/result.h"
#include "gonio/client/client.h"
#include "gonio/v1/error.pb.h"

namespace gonio::client {

// A failed try.
struct Failure {
  Error error;
  bool may_retry = false;
  std::optional<std::chrono::milliseconds> pushback;  // the pause that the server asks for
};

// UNAVAILABLE may be tried again, RESOURCE_EXHAUSTED where the server says when (otherwise it means
// "too large"), and neither where it says never (a negative pushback, as in gRPC's retry design
// A6, or one of more than a minute). `peer` is the server's name in messages.
Failure failure_of(const grpc::Status& status, const grpc::ClientContext& context,
                   const std::string& peer);
// The same for a chunk of a stream that is otherwise well.
Failure failure_of(const gonio::v1::ErrorDetail& detail);

class Patience {
 public:
  using Clock = std::chrono::system_clock;

  Patience(const ClientOptions& options, std::optional<std::chrono::milliseconds> deadline);

  // none: no deadline.
  [[nodiscard]] std::optional<Clock::time_point> deadline() const { return deadline_; }
  // Something came back: the count of tries in vain starts again.
  void progress() { in_vain_ = 0; }
  // Pauses before the next try. False if there is to be none.
  bool pause_to_retry(const Failure& failure);
  [[nodiscard]] int retries() const { return retries_; }

 private:
  std::chrono::milliseconds next_pause(const Failure& failure);

  int max_retries_;
  std::chrono::milliseconds backoff_;
  std::optional<Clock::time_point> deadline_;
  int in_vain_ = 0;
  int retries_ = 0;
};

}  // namespace gonio::client
