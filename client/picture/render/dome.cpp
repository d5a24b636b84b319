#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "client/picture/render/light.h"

namespace gonio::render {
namespace {

using image::Image;
using image::luminance;
using std::numbers::pi;

// The index of the step of a cumulative sum that holds `target`, and how far in it that is (0 to
// 1).
std::pair<int, double> find_step(const double* sums, int count, double target) {
  const double* above = std::upper_bound(sums, sums + count - 1, target);
  const double before = above == sums ? 0 : above[-1];
  const double width = *above - before;
  const double within = width > 0 ? std::clamp((target - before) / width, 0.0, 1.0) : 0.5;
  return {static_cast<int>(above - sums), within};
}

// A piecewise constant density over the texels: a row by its share of the light, then a column in
// it (Pharr, Jakob & Humphreys 2016, Physically Based Rendering, 13.6.7), then a point in the
// texel, uniform in solid angle: every texel of a row covers the same cosines.
class Dome : public Light {
 public:
  explicit Dome(Image map) : map_(std::move(map)), columns_(map_.pixels.size()) {
    double sum = 0;
    for (int row = 0; row < map_.height; ++row) {
      double row_sum = 0;
      for (int column = 0; column < map_.width; ++column) {
        row_sum += luminance(map_.at(column, row));
        columns_[first_of(row) + static_cast<std::size_t>(column)] = row_sum;
      }
      sum += row_sum * texel_solid_angle(row);
      rows_.push_back(sum);
    }
  }

  // The light's luminance, integrated over the sphere.
  [[nodiscard]] double total() const { return rows_.back(); }

  [[nodiscard]] Rgb radiance(const Vec3& direction) const override { return texel(direction); }

  [[nodiscard]] Vec3 sample(const Xi& xi) const override {
    const auto [row, y] = find_step(rows_.data(), map_.height, xi[0] * total());
    const double* sums = columns_.data() + first_of(row);
    const auto [column, x] = find_step(sums, map_.width, xi[1] * sums[map_.width - 1]);
    const double z = std::lerp(edge_cosine(row), edge_cosine(row + 1), y);
    const double azimuth = 2 * pi * ((column + x) / map_.width - 0.5);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * std::sin(azimuth), r * std::cos(azimuth), z};
  }

  [[nodiscard]] double density(const Vec3& direction) const override {
    return luminance(texel(direction)) / total();
  }
  [[nodiscard]] bool single_direction() const override { return false; }

 private:
  [[nodiscard]] std::size_t first_of(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.width);
  }
  [[nodiscard]] double edge_cosine(int row) const { return std::cos(pi * row / map_.height); }
  [[nodiscard]] double texel_solid_angle(int row) const {
    return 2 * pi / map_.width * (edge_cosine(row) - edge_cosine(row + 1));
  }
  [[nodiscard]] const Rgb& texel(const Vec3& direction) const {
    const double azimuth = std::atan2(direction.x(), direction.y()) / (2 * pi) + 0.5;
    const double polar = std::acos(std::clamp(direction.z(), -1.0, 1.0)) / pi;
    return map_.at(std::min(static_cast<int>(azimuth * map_.width), map_.width - 1),
                   std::min(static_cast<int>(polar * map_.height), map_.height - 1));
  }

  Image map_;
  std::vector<double> columns_;  // per row, cumulative luminance
  std::vector<double> rows_;     // cumulative, luminance times solid angle
};

Outcome check_texels(const Image& map, const std::string& name) {
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const Rgb& texel = map.at(column, row);
      for (int channel = 0; channel < 3; ++channel) {
        const float value = texel[channel];
        if (value >= 0 && std::isfinite(value)) continue;
        const char* const colours[] = {"red", "green", "blue"};
        return bad_value(name + ": " + colours[channel] + " of the texel in column " +
                             std::to_string(column) + ", row " + std::to_string(row),
                         std::to_string(value), "finite numbers from 0");
      }
    }
  }
  return Ok{};
}

}  // namespace

Result<std::unique_ptr<const Light>> dome_light(Image map, const std::string& name) {
  if (auto checked = check_texels(map, name); !checked) return checked.error();
  auto dome = std::make_unique<Dome>(std::move(map));
  if (!(dome->total() > 0)) {
    return bad_value(name, "black everywhere", "a map with some light");
  }
  return std::unique_ptr<const Light>(std::move(dome));
}

}  // namespace gonio::render
