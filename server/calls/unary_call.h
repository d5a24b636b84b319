// One unary call. `W` is the work it asks for: Evaluation, Sampling or Integration. Made by
// start(), it deletes itself when gRPC is done with it.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <memory>

#include "server/calls/call.h"

namespace gonio::server {

template <class W>
class UnaryCall final : public grpc::ServerUnaryReactor {
 public:
  static UnaryCall* start(const Backend& backend, grpc::CallbackServerContext& context,
                          const grpc::ByteBuffer& request, grpc::ByteBuffer& response);

 private:
  UnaryCall(const Backend& backend, grpc::CallbackServerContext& context,
            grpc::ByteBuffer& response);
  void handle(const grpc::ByteBuffer& request);
  void answer(W& work, bool completed);
  void refuse(const Error& error);
  void end(const grpc::Status& status);
  void OnCancel() override;
  void OnDone() override;

  const Backend& backend_;
  grpc::CallbackServerContext& context_;
  grpc::ByteBuffer& response_;
  CallState state_;
  AccessLine access_;
  MemoryBudget::Charge charge_;  // until the answer is sent
};

}  // namespace gonio::server
