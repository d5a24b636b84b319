#include "bench/echo_client.h"

#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/impl/codegen/client_unary_call.h>

#include "bench/echo_service.h"

namespace gonio::bench {

bool echo_stream(const std::shared_ptr<grpc::Channel>& channel, const EchoEnds& ends,
                 std::size_t count, std::size_t in_flight) {
  enum Tag : std::intptr_t { started, wrote, read, finished };
  const auto tag_of = [](Tag tag) { return reinterpret_cast<void*>(tag); };
  grpc::GenericStub stub(channel);
  grpc::ClientContext context;
  grpc::CompletionQueue queue;
  const auto call = stub.PrepareCall(&context, kEchoMethod, &queue);
  call->StartCall(tag_of(started));
  grpc::ByteBuffer answer;
  std::size_t sent = 0, received = 0;
  bool writable = false, ok = false;
  while (received < count ||
         !writable) {  // the last answer may come before the news that its request has left
    void* tag = nullptr;
    if (!queue.Next(&tag, &ok) || !ok) return false;
    if (tag == tag_of(started)) call->Read(&answer, tag_of(read));
    if (tag == tag_of(read)) {
      ends.take(received, answer);
      if (++received < count) call->Read(&answer, tag_of(read));
    }
    writable = writable || tag != tag_of(read);
    if (!writable || sent == count || sent - received >= in_flight) continue;
    call->Write(ends.message(sent), tag_of(wrote));
    writable = false;
    ++sent;
  }
  grpc::Status status;
  call->WritesDone(tag_of(finished));
  call->Finish(&status, tag_of(finished));
  void* tag = nullptr;
  for (int left = 2; left > 0; --left) queue.Next(&tag, &ok);
  return status.ok();
}

bool raw_unary(grpc::Channel& channel, const char* method, const grpc::ByteBuffer& request,
               grpc::ByteBuffer& response) {
  grpc::ClientContext context;
  const grpc::internal::RpcMethod rpc(method, grpc::internal::RpcMethod::NORMAL_RPC);
  return grpc::internal::BlockingUnaryCall<grpc::ByteBuffer, grpc::ByteBuffer>(
             &channel, rpc, &context, request, &response)
      .ok();
}

}  // namespace gonio::bench
