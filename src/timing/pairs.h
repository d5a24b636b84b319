// Input and output of timed evaluations: pairs of directions over the hemisphere, and memory for
// values. Thread safety: runners that share a Pairs run on one thread at a time.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "gonio/engine/evaluate.h"
#include "gonio/engine/material.h"
#include "timing/race.h"

namespace gonio::timing {

// The default size of a timed batch: a tile, as the server works on.
inline constexpr std::size_t kTimedPairs = kTilePairs;

// Both directions uniform over the hemisphere (cosines from 0.001 up), the same for the same count,
// as separate components, with room so that arrays do not share cache sets.
class Pairs {
 public:
  // `channels`: the largest number of channels that a material evaluated here may have.
  explicit Pairs(std::size_t count, int channels = 3);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const float* component(std::size_t i) const { return in_[i].data(); }
  // The batches of both precisions; their values are written into this object.
  [[nodiscard]] Batch<float, float> fast();
  [[nodiscard]] Batch<float, double> reference();

 private:
  std::size_t count_;
  std::array<std::vector<float>, 6> in_;  // wi x, y, z, wo x, y, z
  std::vector<float> out_;
  std::vector<double> out64_;
};

// Evaluates all pairs once a run, on one thread; an item is a pair.
Runner evaluation(const std::shared_ptr<Pairs>& pairs, const Material& material,
                  Precision precision, Isa isa);

}  // namespace gonio::timing
