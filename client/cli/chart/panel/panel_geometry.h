// Where on the page a panel's numbers are. Thread safety: functions without state.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "client/cli/chart/panel/panel_script.h"

namespace gonio::cli {

// A number's part of the way along an axis.
inline double part_of(const Axis& axis, double x) {
  if (!axis.logarithmic) return (x - axis.low) / (axis.high - axis.low);
  return std::log(x / axis.low) / std::log(axis.high / axis.low);
}

// The nearest that is on it.
inline double clamped(const Axis& axis, double x) { return std::clamp(x, axis.low, axis.high); }

// Pixels of a panel's coordinates.
class Pixels {
 public:
  Pixels(const Panel& panel, const Box& box) : panel_(panel), box_(box) {}
  [[nodiscard]] double x(double value) const {
    return std::lerp(box_.left, box_.right, part_of(panel_.x, clamped(panel_.x, value)));
  }
  [[nodiscard]] double y(double value) const {
    return std::lerp(box_.bottom, box_.top, part_of(panel_.y, clamped(panel_.y, value)));
  }

 private:
  const Panel& panel_;
  const Box& box_;
};

// A place on the page, as scripts have it.
inline std::string on_screen(const Frame& frame, double x, double y) {
  return "screen " + script_number(x / frame.width) + ", screen " + script_number(y / frame.height);
}

}  // namespace gonio::cli
