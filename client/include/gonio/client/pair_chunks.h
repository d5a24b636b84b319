// What Client::evaluate_chunks takes from its caller and gives to it, a part at a time. Thread
// safety: plain values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "gonio/base/result.h"

namespace gonio::client {

// Gives the next pairs: writes n <= wi.size() / 3 of them to the front of both spans and returns n;
// 0 ends the input. Called on the thread that called evaluate_chunks; an error ends the evaluation
// and is passed on.
template <class In>
using PairSource = std::function<Result<std::size_t>(std::span<In> wi, std::span<In> wo)>;

// A run of results. All of it is valid during the call of the sink only.
template <class In, class Out>
struct Chunk {
  std::uint64_t first = 0;  // the number of its first pair
  std::size_t pairs = 0;
  int channels = 0;
  std::span<const In> wi, wo;           // as the source gave them; empty for a grid
  std::span<const Out> values;          // pairs x channels
  std::span<const Out> pdf;             // one a pair, if EvaluateOptions::pdf asked for it
  std::span<const std::uint8_t> flags;  // one byte a pair
};

// Takes the results in the order of the pairs, on the thread that called; an error ends the
// evaluation and is passed on.
template <class In, class Out>
using ChunkSink = std::function<Outcome(const Chunk<In, Out>&)>;

}  // namespace gonio::client
