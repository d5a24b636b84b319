// One Fit call: queues the fit, sends progress while it waits and runs, ends with the result.
//
// The call owns itself until gRPC is done with it and the queue has let go of it. The fit's thread
// only leaves its latest progress here; an alarm sends it, so that a client hears from a fit also
// where one of its steps takes long. Thread safety: mutex_ guards what several threads use, and is
// not held while gRPC is called.
#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <memory>
#include <mutex>
#include <optional>

#include "gonio/v1/fit.pb.h"
#include "server/call.h"
#include "server/fit_request.h"

namespace gonio {

class FitCall final : public grpc::ServerWriteReactor<grpc::ByteBuffer>,
                      public std::enable_shared_from_this<FitCall> {
 public:
  static FitCall* start(const Backend& backend, grpc::CallbackServerContext& context,
                        const grpc::ByteBuffer& request);

 private:
  FitCall(const Backend& backend, grpc::CallbackServerContext& context);
  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

  Outcome enqueue(const grpc::ByteBuffer& request);
  void run();
  Result<fit::FitResult> fit();
  [[nodiscard]] Error over() const;
  void note(v1::FitProgress progress);
  void tick();
  void pump(bool progress_is_due);
  void end(std::optional<v1::FitResponse> result, const grpc::Status& status);

  const Backend& backend_;
  grpc::CallbackServerContext& context_;
  v1::FitRequest request_;  // empty once the data are taken from it
  CallState state_;
  AccessLine access_;
  MemoryBudget::Charge charge_;
  FitTask task_;
  grpc::Alarm alarm_;
  grpc::ByteBuffer outgoing_;  // of the write under way

  std::mutex mutex_;
  v1::FitProgress progress_;
  std::optional<v1::FitResponse> result_;
  std::optional<grpc::Status> end_;  // what is left to say
  bool writing_ = false;
  bool finished_ = false;
  std::shared_ptr<FitCall> self_;
};

}  // namespace gonio
