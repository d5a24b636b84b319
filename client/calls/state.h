// What a Client holds. Internal to the client library. Thread safety: any thread; only the pool of
// queues changes, under a lock of its own.
#pragma once

#include <utility>

#include "client/calls/batch_call.h"
#include "client/rpc/rpc.h"
#include "gonio/client/client.h"

namespace gonio::client {

struct Client::State {
  Peer peer;
  ClientOptions options;

  [[nodiscard]] BatchCall batch_call(const Material& material, Precision precision,
                                     const EvaluateOptions& evaluate_options) const {
    return {peer, options, evaluate_options, material,
            RequestHead::evaluate(material, precision, evaluate_options)};
  }
  // `head`: of another kind.
  [[nodiscard]] BatchCall batch_call(const Material& material, RequestHead head,
                                     const EvaluateOptions& evaluate_options) const {
    return {peer, options, evaluate_options, material, std::move(head)};
  }
};

}  // namespace gonio::client
