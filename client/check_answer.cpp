#include "client/check_answer.h"

#include <utility>

namespace gonio::client {

Error malformed(const Peer& peer, const std::string& what) {
  return {
      ErrorCode::internal, peer.name + " sent an answer that makes no sense: " + what, {}, {}, {}};
}

Outcome check_lengths(const Peer& peer, const OutgoingChunk& chunk, const wire::Response& answer,
                      const Report& report) {
  const std::size_t channels = answer.head.channels();
  const bool f64 = report.precision == Precision::reference;
  if (channels == 0 || (report.channels != 0 && std::cmp_not_equal(channels, report.channels))) {
    return malformed(peer, std::to_string(channels) + " channels");
  }
  if (answer.values.count != chunk.pairs * channels || answer.is_f64 != f64) {
    return malformed(peer, std::to_string(answer.values.count) +
                               (answer.is_f64 ? " float64" : " float32") + " values for " +
                               std::to_string(chunk.pairs) + " pairs of " +
                               std::to_string(channels) + " channels");
  }
  if (answer.flags.count != 0 && answer.flags.count != chunk.pairs) {
    return malformed(peer, std::to_string(answer.flags.count) + " flags for " +
                               std::to_string(chunk.pairs) + " pairs");
  }
  return Ok{};
}

}  // namespace gonio::client
