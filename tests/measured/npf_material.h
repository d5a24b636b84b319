// Real materials: smooth tables fitted to the MERL database, found in $GONIO_DATA/merl.
//
// `npf.bin` holds 273 RGB triples of float32 a material, of pi * f: a diffuse value, a specular
// scale, then 90 of D over theta_h (quadratic cells), 90 of G over theta and 90 of F over theta_d.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "data_folder.h"
#include "measured/synthetic_merl.h"

namespace gonio::testing {

class NpfMaterial {
 public:
  // Nothing if the data folder or the material is absent.
  static std::optional<NpfMaterial> load(const std::string& name) {
    const auto folder = data_folder() / "merl";
    std::ifstream names(folder / "npf_names.txt");
    std::streamoff row = 0;
    std::string line;
    while (std::getline(names, line) && line != name) ++row;
    NpfMaterial material;
    std::ifstream tables(folder / "npf.bin", std::ios::binary);
    tables.seekg(row * static_cast<std::streamoff>(sizeof material.table_));
    tables.read(reinterpret_cast<char*>(material.table_.data()), sizeof material.table_);
    if (line != name || !tables) return std::nullopt;
    return material;
  }

  // f in 1/sr; negative below the horizon, as the database marks it.
  Rgb operator()(double theta_h, double theta_d, double phi_d) const {
    const double across = std::sin(theta_h) * std::sin(theta_d) * std::cos(phi_d);
    const double along = std::cos(theta_h) * std::cos(theta_d);
    const double cos_i = along - across;
    const double cos_o = along + across;
    if (cos_i <= 0 || cos_o <= 0) return {-1, -1, -1};
    Rgb f{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double shadowing =
          at(kG, linear(std::acos(cos_i)), c) * at(kG, linear(std::acos(cos_o)), c);
      const double lobe =
          at(kScale, 0, c) * at(kD, quadratic(theta_h), c) * at(kF, linear(theta_d), c);
      f[c] = (at(kDiffuse, 0, c) + lobe * shadowing / (cos_i * cos_o)) / std::numbers::pi;
    }
    return f;
  }

 private:
  static constexpr std::size_t kDiffuse = 0, kScale = 1, kD = 2, kG = 92, kF = 182;

  static std::size_t cell(double part) {
    return static_cast<std::size_t>(std::clamp(part * 90, 0.0, 89.0));
  }
  static std::size_t linear(double angle) { return cell(angle / (std::numbers::pi / 2)); }
  static std::size_t quadratic(double angle) {
    return cell(std::sqrt(angle / (std::numbers::pi / 2)));
  }
  double at(std::size_t column, std::size_t offset, std::size_t channel) const {
    return static_cast<double>(table_[(column + offset) * 3 + channel]);
  }

  std::array<float, 273 * 3> table_{};
};

}  // namespace gonio::testing
