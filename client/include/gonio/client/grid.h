// Directions as axes: the server expands them, so that a grid costs no bandwidth on its way there.
//
// Angles in radians, theta from the normal. Give either theta_i, phi_i, theta_o, phi_o (nested in
// that order, the last the fastest) or Rusinkiewicz' theta_h, theta_d, phi_d (likewise; phi_h = 0).
// Thread safety: plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace gonio::client {

struct Grid {
  std::vector<double> theta_i, phi_i, theta_o, phi_o;
  std::vector<double> theta_h, theta_d, phi_d;

  [[nodiscard]] bool half_angle() const {
    return !(theta_h.empty() && theta_d.empty() && phi_d.empty());
  }
  // The number of pairs; none if it is beyond 2^63.
  [[nodiscard]] std::optional<std::uint64_t> size() const;
};

}  // namespace gonio::client
