// How a client reaches its server, and how it evaluates. Thread safety: plain values.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "gonio/client/types.h"

namespace gonio::client {

struct ClientOptions {
  // For a call as a whole, with its retries; 0 means none. Without one, a server that hangs makes
  // the call hang.
  std::chrono::milliseconds deadline{0};
  // After this long, an address that does not answer at all counts as unreachable. Not for
  // from_channel().
  std::chrono::milliseconds connect_timeout{5000};
  // Pairs, or samples, in a chunk and in a call; fewer are taken where an answer would exceed 3
  // MiB.
  std::size_t chunk_pairs = 65536;
  // Chunks on their way at a time.
  int in_flight = 4;
  // Tries after the first without any progress between them; 0 means never again.
  int max_retries = 4;
  // The pause before the first retry, doubled for each further one up to 2 s, and varied by a
  // random fifth.
  std::chrono::milliseconds backoff{100};
};

struct EvaluateOptions {
  InstructionSet instruction_set = InstructionSet::best;
  // In place of ClientOptions::deadline.
  std::optional<std::chrono::milliseconds> deadline;
  // evaluate_chunks() then gives Chunk::pdf, the densities of evaluate_with_pdf().
  bool pdf = false;
};

}  // namespace gonio::client
