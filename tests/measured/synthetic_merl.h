// Materials in the layout of the MERL database, made from a function: for tests and demonstrations.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <vector>

namespace gonio::testing {

// Values in 1/sr of the channels R, G and B at half and difference angles in radians; a negative
// one marks the cell as not measured.
using Rgb = std::array<double, 3>;
using IsotropicFunction = std::function<Rgb(double theta_h, double theta_d, double phi_d)>;

inline constexpr std::size_t kMerlThetaH = 90, kMerlThetaD = 90, kMerlPhiD = 180;
inline constexpr std::size_t kMerlCells = kMerlThetaH * kMerlThetaD * kMerlPhiD;
inline constexpr std::uintmax_t kMerlBytes = 12 + 3 * 8 * std::uintmax_t{kMerlCells};
inline constexpr Rgb kMerlScale{1.0 / 1500, 1.15 / 1500, 1.66 / 1500};

// The function at the centre of a cell, cells counted with phi_d the fastest.
inline Rgb at_cell_centre(const IsotropicFunction& f, std::size_t cell) {
  constexpr double kHalfPi = std::numbers::pi / 2;
  const auto h = (static_cast<double>(cell / kMerlPhiD / kMerlThetaD) + 0.5) / kMerlThetaH;
  const auto d = (static_cast<double>(cell / kMerlPhiD % kMerlThetaD) + 0.5) / kMerlThetaD;
  const auto p = (static_cast<double>(cell % kMerlPhiD) + 0.5) / kMerlPhiD;
  return f(h * h * kHalfPi, d * kHalfPi, p * std::numbers::pi);
}

// What MeasuredTable::from_values takes: cell by cell, R G B.
inline std::vector<float> tabulate(const IsotropicFunction& f) {
  std::vector<float> values;
  values.reserve(kMerlCells * 3);
  for (std::size_t cell = 0; cell < kMerlCells; ++cell) {
    for (const double v : at_cell_centre(f, cell)) values.push_back(static_cast<float>(v));
  }
  return values;
}

// Writes a `.binary` file; true if all of it was written.
inline bool write_merl(const std::filesystem::path& file, const IsotropicFunction& f) {
  std::array<std::vector<double>, 3> planes;
  for (std::size_t cell = 0; cell < kMerlCells; ++cell) {
    const Rgb rgb = at_cell_centre(f, cell);
    for (std::size_t c = 0; c < 3; ++c) planes[c].push_back(rgb[c] / kMerlScale[c]);
  }
  std::ofstream out(file, std::ios::binary);
  const std::array<std::int32_t, 3> dimensions{kMerlThetaH, kMerlThetaD, kMerlPhiD};
  out.write(reinterpret_cast<const char*>(dimensions.data()), sizeof dimensions);
  for (const auto& plane : planes) {
    out.write(reinterpret_cast<const char*>(plane.data()),
              static_cast<std::streamsize>(plane.size() * sizeof(double)));
  }
  return static_cast<bool>(out.flush());
}

// A glossy example: a diffuse base and a lobe over theta_h, stronger towards grazing.
inline Rgb glossy_example(double theta_h, double theta_d, double phi_d) {
  const double lobe = std::exp(-std::pow(theta_h / 0.15, 2));
  const double fresnel = 0.05 + 0.95 * std::pow(1 - std::cos(theta_d), 5);
  const double base = 0.2 + 0.05 * std::cos(2 * phi_d) * std::sin(theta_d);
  return {base / 2 + 8 * lobe * fresnel, base / 3 + 8 * lobe * fresnel,
          base / 5 + 7 * lobe * fresnel};
}

}  // namespace gonio::testing
