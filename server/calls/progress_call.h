// A call that queues its work, sends progress while that waits and runs, and ends with the result:
// Fit, Select and Chart.
//
// The call owns itself until gRPC is done with it and the queue has let go of it. The work's thread
// only leaves its latest progress here; an alarm sends it, so that a client hears from the work
// also where one of its steps takes long. Thread safety: mutex_ guards what several threads use,
// and is not held while gRPC is called.
#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "gonio/base/result.h"
#include "server/work/background_work.h"

namespace gonio::server {

class ProgressCall : public grpc::ServerWriteReactor<grpc::ByteBuffer>,
                     public std::enable_shared_from_this<ProgressCall> {
 public:
  // Call: a class derived from this, made from a backend and a context.
  template <class Call>
  static ProgressCall* start(const Backend& backend, grpc::CallbackServerContext& context,
                             const grpc::ByteBuffer& request) {
    const std::shared_ptr<ProgressCall> call = std::make_shared<Call>(backend, context);
    call->begin(request);
    return call.get();
  }
  ~ProgressCall() override;
  ProgressCall(const ProgressCall&) = delete;
  ProgressCall& operator=(const ProgressCall&) = delete;

 protected:
  // `work` as in messages: "the fit".
  ProgressCall(const Backend& backend, grpc::CallbackServerContext& context, const char* method,
               const char* work);

  // Takes the request, which is cheap; gives the memory that the work will need.
  virtual Result<std::size_t> prepare(const grpc::ByteBuffer& request) = 0;
  // The work; its result as a message. An error of `cancelled`: it was stopped. What is thrown ends
  // the call, here as in prepare().
  virtual Result<grpc::ByteBuffer> work() = 0;

  [[nodiscard]] BackgroundWork& background() { return background_; }
  void note(grpc::ByteBuffer progress);  // from now on the latest

 private:
  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

  void begin(const grpc::ByteBuffer& request);
  Outcome enqueue(const grpc::ByteBuffer& request);
  void run();
  void tick();
  void set_alarm();
  void pump(bool progress_is_due);
  // Counts once. Throws nothing: a mutex that fails ends the process.
  // NOLINTBEGIN(bugprone-exception-escape)
  void end(std::optional<grpc::ByteBuffer> result, grpc::Status status) noexcept;
  void fail(grpc::Status status) noexcept { end(std::nullopt, std::move(status)); }
  // NOLINTEND(bugprone-exception-escape)

  BackgroundWork background_;
  grpc::Alarm alarm_;
  grpc::ByteBuffer outgoing_;  // of the write under way

  std::mutex mutex_;
  grpc::ByteBuffer progress_;
  std::optional<grpc::ByteBuffer> result_;
  std::optional<grpc::Status> end_;  // none while the call goes on
  bool writing_ = false;
  bool finished_ = false;
  std::shared_ptr<ProgressCall> self_;
};

}  // namespace gonio::server
