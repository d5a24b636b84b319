// What evaluations are timed on: pairs of directions over the hemisphere, and room for values.
// Thread safety: one thread at a time runs what shares a Pairs.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "gonio/engine/evaluate.h"
#include "gonio/engine/material.h"
#include "timing/race.h"

namespace gonio::timing {

// So many pairs at a time are timed where nothing else is said: a tile, as the server works on.
inline constexpr std::size_t kTimedPairs = kTilePairs;

// Both directions uniform over the hemisphere (cosines from 0.001 up), the same for the same count,
// as separate components, with room so that arrays do not share cache sets.
class Pairs {
 public:
  // `channels` is the most that a material evaluated here may have.
  explicit Pairs(std::size_t count, int channels = 3);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const float* component(std::size_t i) const { return in_[i].data(); }
  // The batches of both precisions; their values are written into this.
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
