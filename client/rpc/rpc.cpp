#include "client/rpc/rpc.h"

#include <utility>

#include "client/rpc/open_call.h"

namespace gonio::client {
namespace {

grpc::Status call_once(const Peer& peer, const char* method, const grpc::ByteBuffer& request,
                       OpenCall& call) {
  call.outgoing = request;
  grpc::GenericStub stub(peer.channel);
  call.reply = stub.PrepareUnaryCall(&call.context, method, call.outgoing, call.queue.get());
  call.reply->StartCall();
  call.reply->Finish(&call.incoming, &call.status, nullptr);
  void* tag = nullptr;
  bool ok = false;
  if (!call.next(&tag, &ok)) return {grpc::StatusCode::DEADLINE_EXCEEDED, "the connection hangs"};
  peer.queues->give_back(std::move(call.queue));
  return call.status;
}

}  // namespace

Result<grpc::ByteBuffer> call(const Peer& peer, const char* method, const grpc::ByteBuffer& request,
                              Patience& patience) {
  for (;;) {
    const OpenCallPointer open(new OpenCall(patience, peer.queues->take()));
    const grpc::Status status = call_once(peer, method, request, *open);
    if (status.ok()) return open->incoming;
    const Failure failure = failure_of(status, open->context, peer.name);
    if (!patience.pause_to_retry(failure)) return failure.error;
  }
}

}  // namespace gonio::client
