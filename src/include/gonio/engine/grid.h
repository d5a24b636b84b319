// Directions from axes: the expansion of a grid request.
//
// Angles in radians. A spherical grid nests theta_i, phi_i, theta_o, phi_o, the last the fastest; a
// half-angle grid (Rusinkiewicz 1998) nests theta_h, theta_d, phi_d, with phi_h = 0. A direction
// whose z differs from 0 by no more than the rounding of its angles (a theta of "90 degrees") lies
// on the horizon: its z is exactly 0. What a pair gets does not depend on the range in which it is
// expanded. Thread safety: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "gonio/base/result.h"

namespace gonio {

// The direction at `theta` from the normal and `phi` from u, as a grid has it: exactly in the
// horizon where theta means that. Writes x, y, z.
template <class T>
void direction_at(double theta, double phi, T* out);

class Grid {
 public:
  // Errors: an empty axis, an angle that is not finite (each named like "theta_i" or "theta_i[3]"),
  // and resource_exhausted for more than 2^63 pairs.
  static Result<Grid> spherical(std::vector<double> theta_i, std::vector<double> phi_i,
                                std::vector<double> theta_o, std::vector<double> phi_o);
  static Result<Grid> half_angle(std::vector<double> theta_h, std::vector<double> theta_d,
                                 std::vector<double> phi_d);

  [[nodiscard]] std::uint64_t size() const { return size_; }

  // Writes the directions of pairs first ... first + count - 1 (which must exist), interleaved xyz.
  void expand(std::uint64_t first, std::size_t count, float* wi, float* wo) const;
  void expand(std::uint64_t first, std::size_t count, double* wi, double* wo) const;

 private:
  // Sine and cosine are taken once per axis value: a pair then costs a few products.
  struct Angle {
    double sin = 0, cos = 1;
  };
  using Axis = std::vector<Angle>;

  static Result<Grid> create(std::span<const std::string_view> names,
                             std::span<const std::vector<double>> axes);
  template <class T>
  void expand_range(std::uint64_t first, std::size_t count, T* wi, T* wo) const;

  std::array<Axis, 4> axes_;  // half-angle: three and an axis of one element
  bool half_angle_ = false;
  std::uint64_t size_ = 0;
};

}  // namespace gonio
