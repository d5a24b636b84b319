#include "client/cli/arguments/grid_spec.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "base/near_names.h"
#include "client/cli/output/numbers.h"

namespace gonio::cli {
namespace {

constexpr const char* kAxisForm = "START:STOP:COUNT or angles such as 0/15/40";
constexpr std::array<std::string_view, 4> kSpherical = {"theta_i", "phi_i", "theta_o", "phi_o"};
constexpr std::array<std::string_view, 3> kHalfAngle = {"theta_h", "theta_d", "phi_d"};

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0;;) {
    const std::size_t end = text.find(separator, start);
    parts.push_back(text.substr(start, end - start));
    if (end == std::string_view::npos) return parts;
    start = end + 1;
  }
}

// An axis as it is written: angles, or a range that is not expanded yet.
struct Axis {
  std::vector<double> angles;
  double start = 0, stop = 0;
  std::uint64_t count = 0;

  // Both ends are met exactly.
  [[nodiscard]] std::vector<double> expand() const {
    if (!angles.empty()) return angles;
    std::vector<double> result(count, start);
    for (std::uint64_t i = 1; i < count; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(count - 1);
      result[i] = i + 1 == count ? stop : start + (stop - start) * t;
    }
    return result;
  }
};

Result<double> parse_angle(std::string_view name, std::string_view text) {
  const std::optional<double> angle = parse_number<double>(text);
  if (angle && std::isfinite(*angle)) return *angle;
  return bad_value("--grid " + std::string(name), "'" + std::string(text) + "'",
                   std::string("finite numbers, as ") + kAxisForm);
}

Result<Axis> parse_range(std::string_view name, const std::vector<std::string_view>& parts) {
  Axis axis;
  auto start = parse_angle(name, parts[0]);
  auto stop = parse_angle(name, parts[1]);
  if (!start) return start.error();
  if (!stop) return stop.error();
  const char* end = parts[2].data() + parts[2].size();
  const auto [at, error] = std::from_chars(parts[2].data(), end, axis.count);
  if (error == std::errc::invalid_argument || at != end || axis.count == 0) {
    return bad_value("the count of --grid " + std::string(name), "'" + std::string(parts[2]) + "'",
                     "a whole number from 1 to " + std::to_string(kMostAngles));
  }
  if (error == std::errc::result_out_of_range || axis.count > kMostAngles) {
    return bad_value("the count of --grid " + std::string(name), std::string(parts[2]),
                     "1 to " + std::to_string(kMostAngles), ErrorCode::resource_exhausted);
  }
  if (axis.count == 1 && *start != *stop) {
    return bad_value("the count of --grid " + std::string(name), "1",
                     "2 or more for a range whose ends differ");
  }
  axis.start = *start;
  axis.stop = *stop;
  return axis;
}

Result<Axis> parse_axis(std::string_view name, std::string_view text) {
  const auto range = split(text, ':');
  if (range.size() == 3) return parse_range(name, range);
  if (range.size() != 1) {
    return bad_value("--grid " + std::string(name), "'" + std::string(text) + "'", kAxisForm);
  }
  Axis axis;
  for (const std::string_view part : split(text, '/')) {
    auto angle = parse_angle(name, part);
    if (!angle) return angle.error();
    axis.angles.push_back(*angle);
  }
  axis.count = axis.angles.size();
  return axis;
}

std::string near_axis(const std::string& name) {
  std::vector<std::string_view> names(kSpherical.begin(), kSpherical.end());
  names.insert(names.end(), kHalfAngle.begin(), kHalfAngle.end());
  return did_you_mean(name, names);
}

using Axes = std::map<std::string, Axis, std::less<>>;

Result<Axes> parse_axes(const std::string& text) {
  Axes axes;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    const std::string name(part.substr(0, equals));
    const bool known = std::count(kSpherical.begin(), kSpherical.end(), name) +
                           std::count(kHalfAngle.begin(), kHalfAngle.end(), name) !=
                       0;
    if (equals == std::string_view::npos || !known) {
      return bad_value(
          "--grid", "'" + std::string(part) + "'",
          "AXIS=ANGLES with theta_i, phi_i, theta_o, phi_o, or theta_h, theta_d, phi_d" +
              (known ? std::string() : near_axis(name)));
    }
    auto axis = parse_axis(name, part.substr(equals + 1));
    if (!axis) return axis.error();
    if (!axes.emplace(name, *axis).second) {
      return bad_value("--grid", name + " given twice", "each axis once");
    }
  }
  return axes;
}

Outcome check_size(const Axes& axes) {
  double pairs = 1;  // no overflow, and exact far beyond the limit
  for (const auto& [name, axis] : axes) pairs *= static_cast<double>(axis.count);
  if (pairs <= static_cast<double>(kMostPairs)) return Ok{};
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.0f", pairs);
  return bad_value("the number of pairs of --grid", digits.data(),
                   "at most " + std::to_string(kMostPairs), ErrorCode::resource_exhausted);
}

}  // namespace

Result<GridSpec> parse_grid(const std::string& text, bool degrees) {
  auto axes = parse_axes(text);
  if (!axes) return axes.error();
  if (auto fits = check_size(*axes); !fits) return fits.error();
  const auto has = [&](std::string_view name) { return axes->find(name) != axes->end(); };
  const bool half = std::any_of(kHalfAngle.begin(), kHalfAngle.end(), has);
  if (half && std::any_of(kSpherical.begin(), kSpherical.end(), has)) {
    return bad_value("--grid", "'" + text + "'",
                     "theta_i, phi_i, theta_o, phi_o, or theta_h, theta_d, phi_d, not both");
  }
  GridSpec spec;
  client::Grid& grid = spec.grid;
  const auto add = [&](std::string_view name, std::vector<double>& angles) {
    const auto found = axes->find(name);
    angles = found == axes->end() ? std::vector<double>{0} : found->second.expand();
    spec.names.emplace_back(name);
    spec.given.push_back(angles);
    for (double& angle : angles) angle *= degrees ? std::numbers::pi / 180 : 1;
  };
  const std::array spherical = {&grid.theta_i, &grid.phi_i, &grid.theta_o, &grid.phi_o};
  const std::array half_angle = {&grid.theta_h, &grid.theta_d, &grid.phi_d};
  for (std::size_t i = 0; half && i < kHalfAngle.size(); ++i) add(kHalfAngle[i], *half_angle[i]);
  for (std::size_t i = 0; !half && i < kSpherical.size(); ++i) add(kSpherical[i], *spherical[i]);
  return spec;
}

}  // namespace gonio::cli
