// One evaluation: from what the caller asks for to the calls and chunks that do it. Internal to the
// client library.
//
// Thread safety: used by one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/result.h"
#include "client/chunks.h"
#include "client/client.h"
#include "client/request_head.h"
#include "client/retry.h"
#include "client/rpc.h"

namespace gonio::client {

inline constexpr std::size_t kMaxChannels = 64;

class Evaluation {
 public:
  Evaluation(const Peer& peer, const ClientOptions& options,
             const EvaluateOptions& evaluate_options, const Material& material,
             Precision precision);

  // Evaluates one pair along the normal: what the material is, without any pairs of the caller's.
  Result<Report> probe();

  // Everything that `source` has, at most `total` pairs if that is known, for a material of
  // `channels`.
  Result<Report> run(ChunkSource& source, ChunkReceiver& receiver, std::size_t channels,
                     std::optional<std::uint64_t> total);

  [[nodiscard]] bool has_deadline() const { return patience_.deadline().has_value(); }

 private:
  [[nodiscard]] std::size_t chunk_limit(std::size_t channels) const;

  const Peer& peer_;
  const ClientOptions& options_;
  Patience patience_;  // for the probe and all that follows
  RequestHead head_;
};

// Errors: axes of both kinds, an axis without angles, more than 2^63 pairs.
Outcome check(const Grid& grid);

}  // namespace gonio::client
