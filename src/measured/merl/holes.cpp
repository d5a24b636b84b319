#include "measured/merl/holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "measured/merl/cells.h"

namespace gonio {
namespace {

constexpr float kDark = 1e-5F;  // 1/sr; differences below are of no light
constexpr int kReach = 3, kReachOfZero = 12;

bool is_brighter(const CellView& view, const Cell& cell, CellAxis axis, int step, float than,
                 int reach) {
  for (int k = 1; k <= reach; ++k) {
    if (view.beside(cell, axis, step * k) > than) return true;  // false for NaN
  }
  return false;
}

bool is_masked_in(const CellView& view, const Cell& cell) {
  const float own = view.at(cell);
  const float than = kMaskedBelow * std::max(own, kDark);
  const int reach = own > 0 ? kReach : kReachOfZero;
  return std::ranges::any_of(std::array{CellAxis::theta_d, CellAxis::theta_h, CellAxis::phi_d},
                             [&](CellAxis axis) {
                               return is_brighter(view, cell, axis, 1, than, reach) &&
                                      is_brighter(view, cell, axis, -1, than, reach);
                             });
}

// Sets the bits of all cells from which a lookup between eight takes a marked one.
void mark_around(const std::vector<std::uint64_t>& cells, std::vector<std::uint64_t>& around) {
  const auto is_hole = [&](const Cell& cell) {
    const std::size_t at = cell.index();
    return (cells[at / 64] >> (at % 64) & 1U) != 0;
  };
  for (int h = 0; h < MeasuredTable::kThetaH; ++h) {
    for (int d = 0; d < MeasuredTable::kThetaD; ++d) {
      for (int p = 0; p < MeasuredTable::kPhiD; ++p) {
        if (!is_hole({h, d, p})) continue;
        for (int corner = 0; corner < 8; ++corner) {
          const Cell base{std::max(0, h - (corner & 1)), std::max(0, d - (corner >> 1 & 1)),
                          (p - (corner >> 2) + MeasuredTable::kPhiD) % MeasuredTable::kPhiD};
          around[base.index() / 64] |= std::uint64_t{1} << (base.index() % 64);
        }
      }
    }
  }
}

}  // namespace

bool is_masked(const float* values, int theta_h, int theta_d, int phi_d) {
  for (std::size_t c = 0; c < MeasuredTable::kChannels; ++c) {
    if (is_masked_in(CellView(values, c), {theta_h, theta_d, phi_d})) return true;
  }
  return false;
}

HoleMap holes_of(const float* values) {
  constexpr std::size_t kWords = (MeasuredTable::kCells + 63) / 64;
  HoleMap map;
  map.cells.resize(kWords);
  for (int h = 0; h < MeasuredTable::kThetaH; ++h) {
    for (int d = 0; d < MeasuredTable::kThetaD; ++d) {
      const CellCosines cosines(h, d);
      for (int p = 0; p < MeasuredTable::kPhiD; ++p) {
        if (!(cosines.at(p)[0] > 0)) continue;  // nothing can be measured there
        const std::size_t cell = Cell{h, d, p}.index();
        if (!std::isnan(values[cell * MeasuredTable::kChannels]) && !is_masked(values, h, d, p))
          continue;
        map.cells[cell / 64] |= std::uint64_t{1} << (cell % 64);
        ++map.count;
      }
    }
  }
  if (map.count == 0) return {};
  map.around.resize(kWords);
  mark_around(map.cells, map.around);
  return map;
}

const HoleMap& MeasuredTable::holes() const {
  std::call_once(search_, [this] { holes_ = holes_of(values_.data()); });
  return holes_;
}

std::string place_of(const Cell& cell) {
  const auto degrees = [](double part, double most) {
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "%.3g", part * most);
    return std::string(text.data());
  };
  const double part = (cell.h + 0.5) / MeasuredTable::kThetaH;
  return "theta_h " + degrees(part * part, 90) + ", theta_d " +
         degrees((cell.d + 0.5) / MeasuredTable::kThetaD, 90) + ", phi_d " +
         degrees((cell.p + 0.5) / MeasuredTable::kPhiD, 180) + " degrees";
}

}  // namespace gonio
