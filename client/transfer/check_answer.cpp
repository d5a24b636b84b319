#include "client/transfer/check_answer.h"

#include <utility>

namespace gonio::client {

Error malformed(const Peer& peer, const std::string& what) {
  return {
      ErrorCode::internal, peer.name + " sent an answer that makes no sense: " + what, {}, {}, {}};
}

Outcome check_lengths(const Peer& peer, const RequestHead& head, const OutgoingChunk& chunk,
                      const Answer& answer, int channels) {
  const bool f64 = head.precision() == Precision::reference;
  if (answer.channels == 0 || (channels != 0 && std::cmp_not_equal(answer.channels, channels))) {
    return malformed(peer, std::to_string(answer.channels) + " channels");
  }
  if (answer.values.count != chunk.pairs * answer.channels || answer.is_f64 != f64) {
    return malformed(peer, std::to_string(answer.values.count) +
                               (answer.is_f64 ? " float64" : " float32") + " values for " +
                               std::to_string(chunk.pairs) + " pairs of " +
                               std::to_string(answer.channels) + " channels");
  }
  if (answer.flags.count != 0 && answer.flags.count != chunk.pairs) {
    return malformed(peer, std::to_string(answer.flags.count) + " flags for " +
                               std::to_string(chunk.pairs) + " pairs");
  }
  if (answer.pdf.count != (head.wants_pdf() ? chunk.pairs : 0)) {
    return malformed(peer, std::to_string(answer.pdf.count) + " densities for " +
                               std::to_string(chunk.pairs) + " pairs");
  }
  if (answer.wo.count != (head.wants_wo() ? 3 * chunk.pairs : 0)) {
    return malformed(peer, std::to_string(answer.wo.count) + " numbers of wo for " +
                               std::to_string(chunk.pairs) + " samples");
  }
  return Ok{};
}

}  // namespace gonio::client
