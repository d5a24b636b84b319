// A distribution of pairs of directions, from a scene: its density, and draws from it.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "numeric/direction.h"
#include "select/scene.h"

namespace gonio::select {

struct Pair {
  Direction wi, wo;
};

class Distribution {
 public:
  explicit Distribution(const Scene& scene);  // which check() has accepted

  // Of pairs, per sr^2; the integral over all pairs is 1. An edge between two bins belongs to one
  // of them. The outer edges belong to the scene, within a rounding of float32. Where wi or wo is
  // the normal there is no azimuth, and the density is the mean over phi.
  [[nodiscard]] double density(const Direction& wi, const Direction& wo) const;
  // Of wi alone, per sr.
  [[nodiscard]] double incident_density(const Direction& wi) const;
  Pair draw(std::mt19937_64& random) const;

 private:
  struct Interval {  // without its lower end
    double lower, upper;
    [[nodiscard]] bool holds(double x) const { return x > lower && x <= upper; }
    [[nodiscard]] double length() const { return upper - lower; }
  };
  struct Box {
    Interval ci, co, phi;  // cosines, and the angle
    double density, incident;
  };
  // Moves the ends that all boxes have together outwards by `edge`.
  void widen(Interval Box::*interval, double edge);

  std::vector<Box> inside_;    // boxes with their tolerance, for densities
  std::vector<Box> boxes_;     // boxes for draws
  std::vector<double> up_to_;  // the shares of the boxes, summed
};

}  // namespace gonio::select
