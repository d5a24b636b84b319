// A call that sends progress and ends with a result (Fit, Select), with its retries. Internal to
// the client library. Thread safety: used by one thread.
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <functional>

#include "client/rpc/retry.h"
#include "client/rpc/rpc.h"
#include "gonio/base/result.h"

namespace gonio::client {

struct ProgressMethod {
  const char* path;
  const char* work;  // in messages: "the fit"
};

// Sends the request until a result has come: again after a pause where the failure says that this
// may help. `stop` may be null; it is asked about 20 times a second, and true ends the call with
// `cancelled`. `take` gets each message, and says whether it was the result.
Outcome call_with_progress(const Peer& peer, const ProgressMethod& method,
                           const grpc::ByteBuffer& request, Patience& patience,
                           const std::function<bool()>& stop,
                           const std::function<bool(grpc::ByteBuffer&)>& take);

}  // namespace gonio::client
