// What all cells of a measured table are worth: how many there are, and which stand out. Thread
// safety: a function without state.
#pragma once

#include <cstdint>
#include <string>

#include "gonio/measured/table.h"

namespace gonio {

struct CellFinding {
  double value = 0;
  std::string where;  // a channel, a range of angles, a cell; empty if nowhere
};

// Shares are of the cells whose directions are both within kReviewed degrees of the normal:
// databases hold little beyond.
inline constexpr double kReviewed = 80;
struct TableReview {
  std::uint64_t cells = 0;  // of which shares are
  CellFinding
      missing;  // the share of invalid ones; where: the channel that lacks most in the whole table
  CellFinding missing_region;  // the same in the worst range of ten cells of one angle
  CellFinding zeros;           // the share of valid ones that hold 0, in the worst channel
  CellFinding holes;           // the share of masked ones (measured/merl/holes.h); where: the first
  // Of all cells above the horizon: how many times as bright one is as what lies two and three
  // cells to both sides of it, along two axes at least (beside a hole it may be along one); and the
  // largest f cos(theta_i) cos(theta_o), in 1/sr.
  CellFinding outlier, extreme;
};
TableReview review(const MeasuredTable& table);

}  // namespace gonio
