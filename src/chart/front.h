// The Pareto front: choices that no other one beats. Thread safety: a function without state.
#pragma once

#include <span>
#include <vector>

namespace gonio::chart {

// Both are better the smaller they are.
struct Tradeoff {
  double cost = 0, error = 0;
};

// Whether each of them is on the front: no other one is as good in both and better in one. What has
// a NaN is not on it and beats nothing.
std::vector<bool> on_front(std::span<const Tradeoff> choices);

}  // namespace gonio::chart
