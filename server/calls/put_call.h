// One PutMaterial call: reads the file's chunks, checks them, has them stored in the background,
// answers. It deletes itself when gRPC is done with it. Thread safety: its steps follow each other.
#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include "server/calls/call.h"
#include "server/calls/upload.h"

namespace gonio::server {

class PutCall final : public grpc::ServerReadReactor<grpc::ByteBuffer> {
 public:
  static PutCall* start(const Backend& backend, grpc::CallbackServerContext& context,
                        grpc::ByteBuffer& response);

 private:
  PutCall(const Backend& backend, grpc::CallbackServerContext& context, grpc::ByteBuffer& response);
  void OnReadDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

  void read();
  Outcome take();
  Outcome queue_storing();
  void store();
  void refuse(const Error& error);
  void end(const grpc::Status& status);

  const Backend& backend_;
  grpc::CallbackServerContext& context_;
  grpc::ByteBuffer& response_;
  CallState state_;
  AccessLine access_;
  Upload upload_;
  grpc::ByteBuffer incoming_;
};

}  // namespace gonio::server
