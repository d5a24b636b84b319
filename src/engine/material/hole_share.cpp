#include "engine/material/hole_share.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/material/material_impl.h"
#include "gonio/engine/evaluate.h"
#include "gonio/measured/table.h"

namespace gonio {
namespace {

constexpr std::size_t kAcross = 32, kDirections = kAcross * kAcross;

// Each stands for the same part of the hemisphere times its cosine.
const std::vector<double>& even_directions() {
  static const auto all = [] {
    std::vector<double> xyz;
    for (std::size_t i = 0; i < kDirections; ++i) {
      const std::size_t row = i / kAcross, column = i % kAcross;
      const double u = (static_cast<double>(row) + 0.5) / kAcross,
                   v = (static_cast<double>(column) + 0.5) / kAcross;
      const double sine = std::sqrt(u), phi = 2 * std::numbers::pi * v;
      xyz.insert(xyz.end(), {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1 - u)});
    }
    return xyz;
  }();
  return all;
}

}  // namespace

bool has_table(const Material& material) { return table_of(material) != nullptr; }

double hole_share(const Material& material, const std::array<double, 3>& wi, Isa isa) {
  if (!has_table(material)) return 0;
  std::vector<double> repeated;
  repeated.reserve(3 * kDirections);
  for (std::size_t i = 0; i < kDirections; ++i)
    repeated.insert(repeated.end(), wi.begin(), wi.end());
  std::vector<double> values(kDirections * MeasuredTable::kChannels);
  std::vector<std::uint8_t> flags(kDirections);
  evaluate(material,
           Batch<double, double>{
               Directions<double>::interleaved(repeated.data()),
               Directions<double>::interleaved(even_directions().data()), kDirections,
               Values<double>::interleaved(values.data(), MeasuredTable::kChannels), flags.data()},
           isa);
  const auto met = std::ranges::count_if(
      flags, [](std::uint8_t f) { return f == flag::hole || f == flag::outside_data; });
  return static_cast<double>(met) / kDirections;
}

}  // namespace gonio
