// The cells of a measured table as places in space: where they are, and what lies beside them along
// an axis. Thread safety: plain values, functions without state.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "gonio/measured/table.h"

namespace gonio {

struct Cell {
  int h, d, p;

  [[nodiscard]] std::size_t index() const {
    return (static_cast<std::size_t>(h) * MeasuredTable::kThetaD + static_cast<std::size_t>(d)) *
               MeasuredTable::kPhiD +
           static_cast<std::size_t>(p);
  }
};

// The cosines of both directions at the centres of all cells with the same theta_h and theta_d.
struct CellCosines {
  double along, across;

  CellCosines(int h, int d) {
    const double part = (h + 0.5) / MeasuredTable::kThetaH;
    const double theta_h = part * part * std::numbers::pi / 2;
    const double theta_d = (d + 0.5) / MeasuredTable::kThetaD * std::numbers::pi / 2;
    along = std::cos(theta_h) * std::cos(theta_d);
    across = std::sin(theta_h) * std::sin(theta_d);
  }
  // The lower and the higher of the two.
  [[nodiscard]] std::array<double, 2> at(int p) const {
    static const auto cosines = [] {
      std::array<double, MeasuredTable::kPhiD> all{};
      for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = std::abs(
            std::cos((static_cast<double>(i) + 0.5) * std::numbers::pi / MeasuredTable::kPhiD));
      return all;
    }();
    const double shift = across * cosines[static_cast<std::size_t>(p)];
    return {along - shift, along + shift};
  }
};

enum class CellAxis : std::uint8_t { theta_h, theta_d, phi_d };

// One channel of a table, seen from a cell.
class CellView {
 public:
  CellView(const float* values, std::size_t channel) : values_(values + channel) {}

  [[nodiscard]] float at(const Cell& cell) const {
    return values_[cell.index() * MeasuredTable::kChannels];
  }
  // The value `steps` cells on; NaN beyond the end. Before the beginning of a colatitude the table
  // goes on as it began: its mirror image is half a turn of phi_d on, which is the same cell.
  [[nodiscard]] float beside(const Cell& cell, CellAxis axis, int steps) const {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    Cell to = cell;
    if (axis == CellAxis::phi_d) {
      to.p = (cell.p + steps + MeasuredTable::kPhiD) % MeasuredTable::kPhiD;
      return at(to);
    }
    int& moved = axis == CellAxis::theta_h ? to.h : to.d;
    moved += steps;
    if (moved < 0) moved = -1 - moved;
    constexpr int kEnd = MeasuredTable::kThetaH;
    static_assert(kEnd == MeasuredTable::kThetaD);
    return moved < kEnd ? at(to) : kNone;
  }

 private:
  const float* values_;
};

// "theta_h 12.3, theta_d 40.5, phi_d 90.5 degrees": the cell's centre.
std::string place_of(const Cell& cell);

}  // namespace gonio
