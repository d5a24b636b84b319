#include "client/rpc.h"

#include <grpcpp/completion_queue.h>

namespace gonio::client {
namespace {

grpc::Status call_once(const Peer& peer, const char* method, const grpc::ByteBuffer& request,
                       grpc::ClientContext& context, grpc::ByteBuffer& response) {
  grpc::GenericStub stub(peer.channel);
  grpc::CompletionQueue queue;
  grpc::Status status;
  auto reader = stub.PrepareUnaryCall(&context, method, request, &queue);
  reader->StartCall();
  reader->Finish(&response, &status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  queue.Next(&tag, &ok);
  queue.Shutdown();
  while (queue.Next(&tag, &ok)) {
  }
  return status;
}

}  // namespace

Result<grpc::ByteBuffer> call(const Peer& peer, const char* method, const grpc::ByteBuffer& request,
                              Patience& patience) {
  for (;;) {
    grpc::ClientContext context;
    if (patience.deadline()) context.set_deadline(*patience.deadline());
    grpc::ByteBuffer response;
    const grpc::Status status = call_once(peer, method, request, context, response);
    if (status.ok()) return response;
    const Failure failure = failure_of(status, context, peer.name);
    if (!patience.pause_to_retry(failure)) return failure.error;
  }
}

}  // namespace gonio::client
