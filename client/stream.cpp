#include "client/stream.h"

#include <utility>

namespace gonio::client {

Stream::Stream(const Peer& peer, const Patience& patience) : peer_(peer.name) {
  if (patience.deadline()) context_.set_deadline(*patience.deadline());
  grpc::GenericStub stub(peer.channel);
  rpc_ = stub.PrepareCall(&context_, kEvaluateStreamMethod, &queue_);
  rpc_->StartCall(as_tag(started));
}

Stream::~Stream() {
  context_.TryCancel();
  drain();
}

void Stream::drain() {
  queue_.Shutdown();
  void* tag = nullptr;
  bool ok = false;
  while (queue_.Next(&tag, &ok)) {
  }
}

void Stream::start_read() {
  incoming_.Clear();
  rpc_->Read(&incoming_, as_tag(read));
}

Stream::Event Stream::next() {
  void* tag = nullptr;
  bool ok = false;
  while (queue_.Next(&tag, &ok)) {
    if (tag == as_tag(read)) {
      if (!ok) return Event::ended;
      message_.Swap(&incoming_);
      start_read();
      return Event::message;
    }
    if (tag == as_tag(started)) {
      if (!ok) return Event::ended;  // no read was started that could say so
      start_read();
    }
    // After a write that failed there may still be answers to read; the read will say when it is
    // over.
    if (tag == as_tag(wrote)) outgoing_.Clear();
    if (tag == as_tag(closed) || !ok) continue;
    writable_ = true;
    return Event::writable;
  }
  return Event::ended;
}

void Stream::write(grpc::ByteBuffer message) {
  outgoing_.Swap(&message);
  writable_ = false;
  rpc_->Write(outgoing_, as_tag(wrote));
}

void Stream::close() {
  while (!writable_) {  // the answer may be here before the news that the request has left
    if (next() == Event::ended) return;
  }
  rpc_->WritesDone(as_tag(closed));
  while (next() != Event::ended) {
  }
}

Failure Stream::failure() {
  grpc::Status status;
  rpc_->Finish(&status, as_tag(finished));
  void* tag = nullptr;
  bool ok = false;
  while (queue_.Next(&tag, &ok) && tag != as_tag(finished)) {
  }
  if (status.ok()) {
    const std::string message = peer_ + " ended the stream without answering every chunk";
    return {Error{ErrorCode::unavailable, message, {}, {}, {}}, true, std::nullopt};
  }
  return failure_of(status, context_, peer_);
}

}  // namespace gonio::client
