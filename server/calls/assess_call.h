// One Assess call: it waits in the queue of fits and runs on a thread of theirs, so that no
// evaluation waits for it; asked again and again whether its caller still waits.
//
// The call owns itself until gRPC is done with it and the queue has let go of it.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <memory>
#include <optional>

#include "assess/assess.h"
#include "server/work/background_work.h"

namespace gonio::server {

class AssessCall final : public grpc::ServerUnaryReactor,
                         public std::enable_shared_from_this<AssessCall> {
 public:
  static AssessCall* start(const Backend& backend, grpc::CallbackServerContext& context,
                           const grpc::ByteBuffer& request, grpc::ByteBuffer& response);

 private:
  AssessCall(const Backend& backend, grpc::CallbackServerContext& context,
             grpc::ByteBuffer& response);
  void OnCancel() override;
  void OnDone() override;

  Outcome enqueue(const grpc::ByteBuffer& request);
  void run();
  void end(const grpc::Status& status);

  BackgroundWork background_;
  grpc::ByteBuffer& response_;
  std::optional<PreparedMaterial> material_;
  assess::Options options_;
  Isa isa_ = Isa::baseline;
  std::shared_ptr<AssessCall> self_;
};

}  // namespace gonio::server
