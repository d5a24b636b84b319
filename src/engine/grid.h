// Directions from axes: the expansion of a grid request.
//
// Angles in radians. A spherical grid nests theta_i, phi_i, theta_o, phi_o, the last the fastest; a half-angle grid
// (Rusinkiewicz 1998) nests theta_h, theta_d, phi_d, with phi_h = 0. Thread safety: plain values.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"

namespace gonio {

class Grid {
 public:
  // Errors: an empty axis, an angle that is not finite, a size beyond 2^63.
  static Result<Grid> spherical(std::vector<double> theta_i, std::vector<double> phi_i, std::vector<double> theta_o,
                                std::vector<double> phi_o);
  static Result<Grid> half_angle(std::vector<double> theta_h, std::vector<double> theta_d, std::vector<double> phi_d);

  [[nodiscard]] std::uint64_t size() const { return size_; }

  // Writes the directions of pairs first ... first + count - 1, interleaved xyz.
  void expand(std::uint64_t first, std::size_t count, float* wi, float* wo) const;
  void expand(std::uint64_t first, std::size_t count, double* wi, double* wo) const;

 private:
  std::array<std::vector<double>, 4> axes_;  // half-angle: three and an axis of one element
  bool half_angle_ = false;
  std::uint64_t size_ = 0;
};

}  // namespace gonio
