// A call under way, and how to be rid of it. Internal to the client library.
//
// gRPC 1.51 does not let go of a call, cancelled or not, while its connection hangs in the middle
// of a write (a server that is frozen and no longer reads). A deadline must end the call for its
// caller all the same, so everything that gRPC may still use belongs to this object, and is left to
// a thread in the background where it is not given back at once. Thread safety: used by one thread.
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/status.h>

#include <memory>

#include "client/rpc/retry.h"

namespace gonio::client {

struct OpenCall {
  OpenCall(const Patience& patience, std::unique_ptr<grpc::CompletionQueue> own_queue);

  // The next event. False if there is none, even a little after the deadline.
  bool next(void** tag, bool* ok);

  grpc::ClientContext context;
  std::unique_ptr<grpc::CompletionQueue> queue;  // taken away when nothing is under way any more
  std::unique_ptr<grpc::GenericClientAsyncReaderWriter> stream;   // either
  std::unique_ptr<grpc::GenericClientAsyncResponseReader> reply;  // or
  grpc::ByteBuffer outgoing, incoming;
  grpc::Status status;
};

struct EndCall {
  void operator()(OpenCall* call) const;  // cancels what is still under way
};
using OpenCallPointer = std::unique_ptr<OpenCall, EndCall>;

}  // namespace gonio::client
