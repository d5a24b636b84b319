#include "client/rpc/stream.h"

#include <grpcpp/generic/generic_stub.h>

namespace gonio::client {
namespace {

enum Tag : std::intptr_t { started = 1, wrote, read, closed, finished };

void* as_pointer(Tag tag) { return reinterpret_cast<void*>(static_cast<std::intptr_t>(tag)); }

}  // namespace

Stream::Stream(const Peer& peer, const char* method, const Patience& patience)
    : peer_(peer.name), call_(new OpenCall(patience, std::make_unique<grpc::CompletionQueue>())) {
  grpc::GenericStub stub(peer.channel);
  call_->stream = stub.PrepareCall(&call_->context, method, call_->queue.get());
  call_->stream->StartCall(as_pointer(started));
}

void Stream::start_read() {
  call_->incoming.Clear();
  call_->stream->Read(&call_->incoming, as_pointer(read));
}

Stream::Event Stream::next() {
  void* tag = nullptr;
  bool ok = false;
  while (call_->next(&tag, &ok)) {
    if (tag == as_pointer(read)) {
      if (!ok) return Event::ended;
      message_.Swap(&call_->incoming);
      start_read();
      return Event::message;
    }
    if (tag == as_pointer(started)) {
      if (!ok) return Event::ended;  // no read was started that could say so
      start_read();
    }
    // After a write that failed there may still be answers to read; the read will say when it is
    // over.
    if (tag == as_pointer(wrote)) call_->outgoing.Clear();
    if (tag == as_pointer(closed) || !ok) continue;
    writable_ = true;
    return Event::writable;
  }
  return Event::ended;
}

void Stream::write(const grpc::ByteBuffer& message) {
  call_->outgoing = message;
  writable_ = false;
  call_->stream->Write(call_->outgoing, as_pointer(wrote));
}

void Stream::close() {
  while (!writable_) {  // the answer may be here before the news that the request has left
    if (next() == Event::ended) return;
  }
  call_->stream->WritesDone(as_pointer(closed));
  while (next() != Event::ended) {
  }
}

Failure Stream::failure() {
  call_->stream->Finish(&call_->status, as_pointer(finished));
  void* tag = nullptr;
  bool ok = false;
  while (tag != as_pointer(finished)) {
    if (call_->next(&tag, &ok)) continue;
    const grpc::Status hangs(grpc::StatusCode::DEADLINE_EXCEEDED, "the connection hangs");
    return failure_of(hangs, call_->context, peer_);
  }
  if (!call_->status.ok()) return failure_of(call_->status, call_->context, peer_);
  const std::string message = peer_ + " ended the stream without answering every chunk";
  return {Error{ErrorCode::unavailable, message, {}, {}, {}}, true, std::nullopt};
}

}  // namespace gonio::client
