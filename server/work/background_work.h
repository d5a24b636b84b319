// What calls share whose work takes seconds (Fit, Assess, Select): a place in the queue of such
// work, memory, a deadline of the server's own, and what is said of them.
//
// Thread safety: submit() once, then any thread.
#pragma once

#include <grpcpp/support/status.h>

#include <exception>
#include <functional>
#include <string>

#include "server/calls/call.h"

namespace gonio::server {

class BackgroundWork {
 public:
  // `method` as in the log, `work` as in messages: "the fit".
  BackgroundWork(const Backend& backend, grpc::CallbackServerContext& context, const char* method,
                 const char* work);

  // Charges the memory and queues `run`, which is then called exactly once on a thread that no
  // evaluation waits for. Where it throws, `failed` is called with the status that ends the call;
  // it must not throw. Errors: the queue or the memory is full, with when to come again.
  Outcome submit(std::size_t bytes, std::function<void()> run,
                 std::function<void(grpc::Status)> failed);

  // What ends a call whose work throws `failure`; writes a line of the log.
  [[nodiscard]] grpc::Status status_of(const std::exception_ptr& failure) const noexcept;

  // What a job asks again and again; evaluations get on meanwhile.
  [[nodiscard]] bool should_stop() const;
  [[nodiscard]] bool is_over() const { return state_.is_over(); }
  // Why it is over: cancelled, or past a deadline.
  [[nodiscard]] Error over() const;
  // A job's error, or why it was stopped.
  [[nodiscard]] Error error_of(const Error& of_the_job) const;

  void cancel();                            // by the client
  void stop_writing() { state_.cancel(); }  // nobody reads any more
  // Once; writes the line of the log.
  void ended(const grpc::Status& status) noexcept;
  [[nodiscard]] const CallState* state() const { return &state_; }
  AccessLine& access() { return access_; }
  [[nodiscard]] const Backend& backend() const { return backend_; }

 private:
  const Backend& backend_;
  grpc::CallbackServerContext& context_;
  std::string work_;
  CallState state_;
  AccessLine access_;
  MemoryBudget::Charge charge_;
};

}  // namespace gonio::server
