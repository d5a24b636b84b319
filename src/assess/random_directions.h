// Directions drawn at random, for the catalogue of places. Thread safety: one Random a thread.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "assess/subject.h"
#include "numeric/direction.h"

namespace gonio::assess {

inline constexpr double kPi = std::numbers::pi, kDegree = kPi / 180;

// Random numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  // Uniform in the logarithm.
  double logarithmic(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  double turn() { return uniform(0, 2 * kPi); }
  Direction hemisphere();
  Direction grazing();

 private:
  std::mt19937_64 engine_;
};

// By the elevation, which keeps its digits at the horizon.
inline Direction elevated(double elevation, double phi) {
  return {std::cos(elevation) * std::cos(phi), std::cos(elevation) * std::sin(phi),
          std::sin(elevation)};
}

inline Direction Random::hemisphere() { return spherical(std::acos(uniform(0, 1)), turn()); }
// Down to the cosine at which the error bounds end.
inline Direction Random::grazing() { return elevated(logarithmic(1.1e-6, 10 * kDegree), turn()); }

inline Direction mirrored(const Direction& w) { return {-w[0], -w[1], w[2]}; }

// The other direction of a half-vector.
inline Pair about(const Direction& wi, const Direction& h) {
  const double twice = 2 * dot(wi, h);
  return {wi, {twice * h[0] - wi[0], twice * h[1] - wi[1], twice * h[2] - wi[2]}};
}

// Both directions at an angle of cosine `c` to a half-vector, on opposite sides.
inline Pair around(const Direction& h, double c, double phi) {
  const double s = std::sqrt(std::max(0.0, 1 - c * c));
  const double theta = std::acos(h[2]), azimuth = std::atan2(h[1], h[0]);
  const Direction a = spherical(theta + kPi / 2, azimuth),
                  b = spherical(kPi / 2, azimuth + kPi / 2);
  Pair pair{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double across = s * (std::cos(phi) * a[k] + std::sin(phi) * b[k]);
    pair.wi[k] = c * h[k] + across;
    pair.wo[k] = c * h[k] - across;
  }
  return pair;
}

}  // namespace gonio::assess
