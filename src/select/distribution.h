// The pairs of directions of a scene as a distribution: its density, and draws from it.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "select/scene.h"

namespace gonio::select {

using Direction = std::array<double, 3>;

struct Pair {
  Direction wi, wo;
};

class Distribution {
 public:
  explicit Distribution(const Scene& scene);  // one that check() has passed

  // Of pairs, per sr^2; the integral over all pairs is 1. The edges of a bin belong to it, so that
  // what lies on one between two bins counts in both.
  [[nodiscard]] double density(const Direction& wi, const Direction& wo) const;
  // Of wi alone, per sr.
  [[nodiscard]] double incident_density(const Direction& wi) const;
  Pair draw(std::mt19937_64& random) const;

 private:
  struct Box {  // cosines and angles
    double ci_lower, ci_upper, co_lower, co_upper, phi_lower, phi_upper;
    double density, incident;
  };
  std::vector<Box> boxes_;
  std::vector<double> up_to_;  // the shares of the boxes, summed
};

}  // namespace gonio::select
