// Slices of `gonio compare`: which range they show, and that lines leave the frame.
#include "client/picture/lobe/slices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "client/picture/lobe/scale.h"

namespace gonio::lobe {
namespace {

constexpr int kWidth = 460, kHeight = 400;
constexpr int kLegend = 60, kTop = 90, kBottom = 342;  // rows: what is above the frame, its ends

// One panel: measured from `least` to `most`, and a line by its values.
template <class Line>
std::vector<std::uint8_t> drawn(double least, double most, const Line& line) {
  SlicePanel panel;
  panel.theta_i = 30;
  for (int theta = -80; theta <= 80; theta += 10) {
    const double part = (theta + 80) / 160.0;
    panel.measured.push_back({static_cast<double>(theta), least * std::pow(most / least, part)});
  }
  std::vector<double> values;
  for (int theta = -90; theta <= 90; ++theta) {
    panel.theta_o.push_back(theta);
    values.push_back(line(theta));
  }
  panel.lines.push_back(values);
  const auto rgb = draw_slices({kWidth, kHeight, "slices", {"line"}, 1}, {panel});
  EXPECT_TRUE(rgb.ok());
  return rgb ? *rgb : std::vector<std::uint8_t>(3 * kWidth * kHeight);
}

// The colour of the first line.
bool is_line(const std::vector<std::uint8_t>& rgb, int x, int y) {
  constexpr int kColour[] = {0, 115, 178};
  for (int c = 0; c < 3; ++c) {
    const auto at = static_cast<std::size_t>(3 * (y * kWidth + x) + c);
    if (std::abs(int{rgb[at]} - kColour[c]) > 60) return false;
  }
  return true;
}

// The longest run of the line's colour in a row below the legend, and that row.
struct Stretch {
  int length = 0, row = 0;
};
Stretch longest_run(const std::vector<std::uint8_t>& rgb) {
  Stretch longest;
  for (int y = kLegend; y < kHeight; ++y) {
    int length = 0;
    for (int x = 0; x < kWidth; ++x) {
      length = is_line(rgb, x, y) ? length + 1 : 0;
      if (length > longest.length) longest = {length, y};
    }
  }
  return longest;
}

TEST(Slices, ALineBeyondTheRangeLeavesTheFrame) {
  const auto rgb = drawn(0.1, 0.9, [](int theta) { return std::abs(theta) < 20 ? 1e6 : 0.0; });
  const Stretch run = longest_run(rgb);
  EXPECT_GT(run.length, 0);  // where it comes and goes
  EXPECT_LT(run.length, 10) << "along row " << run.row;
}

TEST(Slices, TheRangeTakesInALineADecadeBeyondTheData) {
  const auto above = longest_run(drawn(0.11, 0.9, [](int) { return 5.0; }));
  EXPECT_GT(above.length, 300);
  EXPECT_NEAR(above.row, kBottom - (1 + std::log10(0.5) / 2) * (kBottom - kTop), 2);
  const auto below = longest_run(drawn(0.11, 0.9, [](int) { return 0.05; }));
  EXPECT_GT(below.length, 300);
  EXPECT_NEAR(below.row, kBottom - (1 + std::log10(0.05) / 2) * (kBottom - kTop), 2);
}

// What is measured keeps its place: six decades are all that are shown.
TEST(Slices, ALineTakesNoRoomFromTheData) {
  EXPECT_EQ(longest_run(drawn(1.1e-6, 0.9, [](int) { return 50.0; })).length, 0);
}

TEST(Scale, UnboundedPositionsGoOnBeyondBothEnds) {
  const Scale log(ScaleKind::log, 0.01, 1);
  EXPECT_DOUBLE_EQ(log.unbounded_position(0.1), log.position(0.1));
  EXPECT_DOUBLE_EQ(log.unbounded_position(100), 2);
  EXPECT_DOUBLE_EQ(log.unbounded_position(1e-4), -1);
  for (const double value : {0.0, -1.0}) EXPECT_TRUE(std::isfinite(log.unbounded_position(value)));
  EXPECT_LT(log.unbounded_position(0), -20);
  const Scale linear(ScaleKind::linear, 0, 1);
  EXPECT_DOUBLE_EQ(linear.unbounded_position(3), 3);
}

}  // namespace
}  // namespace gonio::lobe
