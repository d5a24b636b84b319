// Calls with raw bytes, for what the generated stubs would not send or do not know.
#pragma once

#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>

#include <memory>
#include <string>
#include <utility>

namespace gonio::server::testing {

// One message there and at most one back, of a unary or a streaming method.
inline std::pair<grpc::Status, grpc::ByteBuffer> raw_call(
    const std::shared_ptr<grpc::Channel>& channel, const std::string& method,
    const grpc::ByteBuffer& request) {
  grpc::GenericStub stub(channel);
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  void* tag = nullptr;
  bool ok = false;
  const auto call = stub.PrepareCall(&context, method, &queue);
  call->StartCall(&tag);
  queue.Next(&tag, &ok);
  call->WriteLast(request, grpc::WriteOptions(), &tag);
  queue.Next(&tag, &ok);
  grpc::ByteBuffer response;
  call->Read(&response, &tag);
  queue.Next(&tag, &ok);
  grpc::Status status;
  call->Finish(&status, &tag);
  queue.Next(&tag, &ok);
  return {status, response};
}

}  // namespace gonio::server::testing
