// The Pareto front: choices that no other one beats. Thread safety: a function without state.
#pragma once

#include <span>
#include <vector>

namespace gonio::chart {

// Smaller is better for both.
struct Tradeoff {
  double cost = 0, error = 0;
};

// Whether each choice is on the front: no other one is at least as good in both and better in one.
// A choice with a NaN is not on the front and beats none.
std::vector<bool> on_front(std::span<const Tradeoff> choices);

}  // namespace gonio::chart
