// One call of the client for a batch: an evaluation, or a drawing of samples. It decides how large
// the chunks are, and between a unary call and streams. Internal to the client library.
//
// Thread safety: used by one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "client/messages/request_head.h"
#include "client/rpc/retry.h"
#include "client/rpc/rpc.h"
#include "client/transfer/chunk.h"
#include "gonio/base/result.h"
#include "gonio/client/client.h"

namespace gonio::client {

inline constexpr std::size_t kMaxChannels = 64;

class BatchCall {
 public:
  // `material` outlives the call.
  BatchCall(const Peer& peer, const ClientOptions& options, const EvaluateOptions& evaluate_options,
            const Material& material, RequestHead head);

  // Evaluates one pair along the normal. The report says what the material is.
  Result<Report> probe();

  // The same for a caller without pairs: the material is checked, the report counts no pairs.
  Result<Report> probe_for_nothing();

  // Everything that `source` has, at most `total` pairs if that is known, for a material of
  // `channels`.
  Result<Report> run(ChunkSource& source, ChunkReceiver& receiver, std::size_t channels,
                     std::optional<std::uint64_t> total);

  [[nodiscard]] bool has_deadline() const { return patience_.deadline().has_value(); }

 private:
  [[nodiscard]] std::size_t chunk_limit(std::size_t channels) const;

  const Peer& peer_;
  const ClientOptions& options_;
  EvaluateOptions evaluate_options_;
  const Material& material_;
  Patience patience_;  // for the probe and all that follows
  RequestHead head_;
};

// A probe's report as that of nothing at all.
Report about_nothing(Report probed);

template <class T>
constexpr Precision precision_for() {
  return std::is_same_v<T, double> ? Precision::reference : Precision::fast;
}

// Whether results of `items` ("pairs") have room: `values` for 1 to 64 channels, `flags` none or
// one an item. `name`: what the values are called.
Outcome check_result_lengths(const char* items, std::uint64_t count, const char* name,
                             std::size_t values, std::size_t flags);

// Errors: axes of both kinds, an axis without angles, more than 2^63 pairs.
Outcome check(const Grid& grid);

}  // namespace gonio::client
