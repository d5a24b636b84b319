#include "gonio/client/grid.h"

#include <array>
#include <cstddef>
#include <limits>

namespace gonio::client {

std::optional<std::uint64_t> Grid::size() const {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max();
  const std::array<std::size_t, 4> spherical = {theta_i.size(), phi_i.size(), theta_o.size(),
                                                phi_o.size()};
  const std::array<std::size_t, 4> half = {theta_h.size(), theta_d.size(), phi_d.size(), 1};
  std::uint64_t product = 1;
  for (const std::uint64_t length : half_angle() ? half : spherical) {
    if (length != 0 && product > kMost / length) return std::nullopt;
    product *= length;
  }
  return product;
}

}  // namespace gonio::client
