#include "gonio/engine/grid.h"

#include <cassert>
#include <cmath>
#include <string>

#include "numeric/direction.h"

namespace gonio {
namespace {

constexpr std::uint64_t kMaxPairs = std::uint64_t{1} << 63;

// Two angles, each off by half an ulp of pi/2, and the products of their sines and cosines leave no
// more than this of a z that should be 0.
constexpr double kHorizon = 4.5e-16;

template <class T>
void store(const Direction& w, T* out) {
  out[0] = static_cast<T>(w[0]);
  out[1] = static_cast<T>(w[1]);
  out[2] = std::abs(w[2]) <= kHorizon ? T{0} : static_cast<T>(w[2]);
}

// Turns a direction about v, the normal towards theta_h: from the half-vector's frame to the
// surface's.
Direction tilt(double sin_h, double cos_h, const Direction& d) {
  return {cos_h * d[0] + sin_h * d[2], d[1], cos_h * d[2] - sin_h * d[0]};
}

}  // namespace

template <class T>
void direction_at(double theta, double phi, T* out) {
  store(spherical(theta, phi), out);
}

template void direction_at(double, double, float*);
template void direction_at(double, double, double*);

Result<Grid> Grid::spherical(std::vector<double> theta_i, std::vector<double> phi_i,
                             std::vector<double> theta_o, std::vector<double> phi_o) {
  constexpr std::array<std::string_view, 4> kNames{"theta_i", "phi_i", "theta_o", "phi_o"};
  const std::array axes{std::move(theta_i), std::move(phi_i), std::move(theta_o), std::move(phi_o)};
  return create(kNames, axes);
}

Result<Grid> Grid::half_angle(std::vector<double> theta_h, std::vector<double> theta_d,
                              std::vector<double> phi_d) {
  constexpr std::array<std::string_view, 3> kNames{"theta_h", "theta_d", "phi_d"};
  const std::array axes{std::move(theta_h), std::move(theta_d), std::move(phi_d)};
  auto grid = create(kNames, axes);
  if (grid) grid->half_angle_ = true;
  return grid;
}

Result<Grid> Grid::create(std::span<const std::string_view> names,
                          std::span<const std::vector<double>> axes) {
  Grid grid;
  grid.axes_.fill({Angle{}});
  grid.size_ = 1;
  std::string product;
  bool too_large = false;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const std::vector<double>& axis = axes[a];
    if (axis.empty()) return bad_value(std::string(names[a]), "empty", "at least one angle");
    grid.axes_[a].clear();
    for (std::size_t i = 0; i < axis.size(); ++i) {
      if (!std::isfinite(axis[i])) {
        return bad_value(std::string(names[a]) + "[" + std::to_string(i) + "]",
                         std::to_string(axis[i]), "finite angles in radians");
      }
      grid.axes_[a].push_back({std::sin(axis[i]), std::cos(axis[i])});
    }
    product += (a == 0 ? "" : " x ") + std::to_string(axis.size());
    too_large = too_large || axis.size() > kMaxPairs / grid.size_;
    if (!too_large) grid.size_ *= axis.size();
  }
  if (too_large)
    return bad_value("grid", product + " pairs", "at most 2^63", ErrorCode::resource_exhausted);
  return grid;
}

template <class T>
void Grid::expand_range(std::uint64_t first, std::size_t count, T* wi, T* wo) const {
  assert(first <= size_ && count <= size_ - first);
  std::array<std::size_t, 4> at{};
  for (std::size_t a = 4; a-- > 0; first /= axes_[a].size()) at[a] = first % axes_[a].size();
  for (std::size_t i = 0; i < count; ++i, wi += 3, wo += 3) {
    const Angle& a0 = axes_[0][at[0]];
    const Angle& a1 = axes_[1][at[1]];
    const Angle& a2 = axes_[2][at[2]];
    if (half_angle_) {
      const Direction d{a1.sin * a2.cos, a1.sin * a2.sin, a1.cos};
      store(tilt(a0.sin, a0.cos, d), wi);
      store(tilt(a0.sin, a0.cos, {-d[0], -d[1], d[2]}), wo);
    } else {
      const Angle& a3 = axes_[3][at[3]];
      store({a0.sin * a1.cos, a0.sin * a1.sin, a0.cos}, wi);
      store({a2.sin * a3.cos, a2.sin * a3.sin, a2.cos}, wo);
    }
    for (std::size_t a = 4; a-- > 0;) {
      if (++at[a] < axes_[a].size()) break;
      at[a] = 0;
    }
  }
}

void Grid::expand(std::uint64_t first, std::size_t count, float* wi, float* wo) const {
  expand_range(first, count, wi, wo);
}

void Grid::expand(std::uint64_t first, std::size_t count, double* wi, double* wo) const {
  expand_range(first, count, wi, wo);
}

}  // namespace gonio
