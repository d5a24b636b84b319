#include "chart/example.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "gonio/engine/evaluate.h"

namespace gonio::chart {
namespace {

using Table = MeasuredTable;
using Numbers = std::vector<double>;

Material paint() {
  const auto ggx = [](double alpha, Numbers scale) {
    return LobeSpec{"ggx",
                    {{"alpha_x", Numbers{alpha}},
                     {"alpha_y", Numbers{alpha}},
                     {"eta", Numbers{1.5}},
                     {"scale", std::move(scale)}}};
  };
  return *Material::create(
      {.model = {},
       .diffuse =
           LobeSpec{"oren_nayar", {{"rd", Numbers{0.35, 0.12, 0.06}}, {"sigma", Numbers{0.4}}}},
       .specular = {ggx(0.06, {0.6, 0.6, 0.6}), ggx(0.3, {0.5, 0.4, 0.35})}});
}

// Directions of one theta_h's cells at their centres.
struct Cells {
  std::vector<float> wi, wo, values;

  explicit Cells(int h) {
    constexpr double kPi = std::numbers::pi;
    const double part = (h + 0.5) / Table::kThetaH, theta_h = part * part * kPi / 2;
    const double sh = std::sin(theta_h), ch = std::cos(theta_h);
    for (int d = 0; d < Table::kThetaD; ++d) {
      const double theta_d = (d + 0.5) / Table::kThetaD * kPi / 2;
      const double sd = std::sin(theta_d), cd = std::cos(theta_d);
      for (int p = 0; p < Table::kPhiD; ++p) {
        const double phi_d = (p + 0.5) / Table::kPhiD * kPi;
        const double x = sd * std::cos(phi_d), y = sd * std::sin(phi_d);
        push(wi, sh * cd + ch * x, y, ch * cd - sh * x);
        push(wo, sh * cd - ch * x, -y, ch * cd + sh * x);
      }
    }
    values.resize(wi.size());
  }
  static void push(std::vector<float>& to, double x, double y, double z) {
    for (const double v : {x, y, z}) to.push_back(static_cast<float>(v));
  }
};

}  // namespace

std::shared_ptr<const MeasuredTable> example_table(std::uint64_t seed) {
  const Material material = paint();
  std::mt19937_64 random(seed);
  std::normal_distribution<float> noise(1, 0.02F);
  std::vector<float> values;
  values.reserve(Table::kCells * Table::kChannels);
  for (int h = 0; h < Table::kThetaH; ++h) {
    Cells cells(h);
    const std::size_t count = cells.wi.size() / 3;
    evaluate(material,
             Batch<float, float>{Directions<float>::interleaved(cells.wi.data()),
                                 Directions<float>::interleaved(cells.wo.data()), count,
                                 Values<float>::interleaved(cells.values.data(), Table::kChannels),
                                 nullptr},
             best_isa());
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
      const bool known = cells.wi[i / 3 * 3 + 2] > 0 && cells.wo[i / 3 * 3 + 2] > 0;
      values.push_back(known ? std::max(0.0F, cells.values[i] * noise(random))
                             : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return *Table::from_values(values);
}

}  // namespace gonio::chart
