// Whether an answer is one to the chunk that was sent. Internal to the client library.
//
// Lengths are checked here once, so that the receivers can rely on them. Thread safety: functions
// without state.
#pragma once

#include <string>

#include "client/messages/request_head.h"
#include "client/rpc/rpc.h"
#include "client/transfer/chunk.h"
#include "gonio/base/result.h"

namespace gonio::client {

// The error of a server that does not keep to the protocol.
Error malformed(const Peer& peer, const std::string& what);

// `head`: of the request. `channels`: of the answers before this one, or 0.
Outcome check_lengths(const Peer& peer, const RequestHead& head, const OutgoingChunk& chunk,
                      const Answer& answer, int channels);

}  // namespace gonio::client
