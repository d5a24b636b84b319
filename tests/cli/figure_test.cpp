// Figures of charts: where labels go, how axes end, and what gnuplot is told.
#include "client/cli/chart/figure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "client/cli/chart/panel/labels.h"

namespace gonio::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::Pair;

constexpr double kFont = 10;

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

// At most what letters are wide and high.
Box box_of(const LabelPlace& place, const std::string& text) {
  const double width = 0.6 * kFont * static_cast<double>(text.size());
  const double left = place.at_left ? place.x - width : place.x;
  return {left, place.y - kFont / 2, left + width, place.y + kFont / 2};
}

TEST(Labels, StandBesideMarksAndNotOnOneAnother) {
  const Box area{0, 0, 400, 300};
  std::vector<LabelWanted> wanted;
  std::vector<Box> marks;
  for (int i = 0; i < 6; ++i) {  // a crowd
    const double x = 200 + 9 * i, y = 150 + 5 * (i % 3);
    wanted.push_back({x, y, "choice " + std::to_string(i)});
    marks.push_back({x - 4, y - 4, x + 4, y + 4});
  }
  const auto places = place_labels(wanted, marks, area, kFont);
  ASSERT_EQ(places.size(), wanted.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Box box = box_of(places[i], wanted[i].text);
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(overlap(box, box_of(places[k], wanted[k].text))) << i << " and " << k;
    for (const Box& mark : marks) EXPECT_FALSE(overlap(box, mark)) << i;
  }
}

TEST(Labels, StayInside) {
  const Box area{0, 0, 200, 100};
  const std::vector<LabelWanted> corners{{195, 95, "upper right"}, {5, 5, "lower left"}};
  const auto places = place_labels(corners, {}, area, kFont);
  for (std::size_t i = 0; i < 2; ++i) {
    const Box box = box_of(places[i], corners[i].text);
    EXPECT_GE(box.left, area.left);
    EXPECT_LE(box.right, area.right);
    EXPECT_GE(box.bottom, area.bottom);
    EXPECT_LE(box.top, area.top);
  }
}

TEST(Axes, EndAtRoundNumbers) {
  EXPECT_THAT(log_range({3, 40}, 1), Pair(2, 50));
  EXPECT_THAT(log_range({1, 10}, 1), Pair(1, 10));
  EXPECT_THAT(log_range({1, 10}, 1.5), Pair(0.5, 20));
  EXPECT_THAT(log_range({0, -1, std::numeric_limits<double>::quiet_NaN()}, 1), Pair(1, 10));
}

TEST(Script, HasEverythingOfAFigure) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Figure figure{"name", "a 'caption' `date`", 300, 200, 1, {}};
  figure.panels.push_back({"title",
                           {"cost", 1, 100},
                           {"error", 1e-8, 1},
                           {{"kind",
                             "#123456",
                             Shape::square,
                             true,
                             {{2, 3, 1e-4, 1e-5, "label"}, {5678, none, 1e-12, none}}}},
                           {{{2, 1e-4}}},
                           true});
  const std::string script = figure_script(figure);
  for (const char* words :
       {"set output \"name.svg\"", "set output \"name.png\"", "'a ''caption'' `date`'",
        "with steps", "'label'", "title 'kind'", "#123456", "set logscale x", "2 3 0.0001 1e-05",
        "100 NaN 1e-08 NaN"})  // what is beyond the axes is at their ends
    EXPECT_THAT(script, HasSubstr(words));
  EXPECT_THAT(script, Not(HasSubstr("5678")));
}

}  // namespace
}  // namespace gonio::cli
