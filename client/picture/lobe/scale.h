// How values become lengths and colours. Thread safety: const.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gonio::lobe {

enum class ScaleKind : std::uint8_t { log, linear, cbrt };

struct Tick {
  double position;  // 0 to 1
  std::string label;
};

class Scale {
 public:
  static constexpr double kFewestDecades = 2, kMostDecades = 6;  // that log shows

  // For values from about `least`, the smallest worth showing, to `most`; both positive. The end is
  // the next round number (log: power of ten). Log shows two to six decades.
  Scale(ScaleKind kind, double least, double most);

  // 0 to 1; what is smaller than the scale shows is 0.
  [[nodiscard]] double position(double value) const;
  // The same without ends: below 0 and above 1 for what the scale does not show, so that a line
  // through it leaves the frame where it does. Finite, also for values that are not positive.
  [[nodiscard]] double unbounded_position(double value) const;
  // Round numbers, three to seven of them, without the 0 of the centre.
  [[nodiscard]] std::vector<Tick> ticks() const;

 private:
  ScaleKind kind_;
  double end_ = 1;
  double decades_ = 0;  // for log
};

}  // namespace gonio::lobe
