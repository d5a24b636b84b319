// The labels of a panel's marks: what they must not stand on, and lines to those that are far off.
#include <algorithm>
#include <cmath>
#include <vector>

#include "client/cli/chart/panel/labels.h"
#include "client/cli/chart/panel/panel_geometry.h"

namespace gonio::cli {
namespace {

// What labels must not stand on: a mark with its bar and line.
void take_mark(const Mark& mark, const Pixels& at, std::vector<Box>& taken) {
  const double x = at.x(mark.x), y = at.y(mark.y);
  taken.push_back({x - 5, y - 5, x + 5, y + 5});
  if (!std::isnan(mark.x_high)) {
    const double other = at.x(mark.x_high);
    taken.push_back({std::min(x, other), y - 2, std::max(x, other), y + 2});
  }
  if (std::isnan(mark.y_other)) return;
  const double other = at.y(mark.y_other);
  taken.push_back({x - 1, std::min(y, other), x + 1, std::max(y, other)});
}

// A front's steps.
void take_front(const Front& front, const Pixels& at, double right, std::vector<Box>& taken) {
  for (std::size_t i = 0; i < front.size(); ++i) {
    const bool last = i + 1 == front.size();
    const double y = at.y(front[i].second), to = last ? right : at.x(front[i + 1].first);
    taken.push_back({at.x(front[i].first), y - 2, to, y + 2});
    if (!last) taken.push_back({to - 2, at.y(front[i + 1].second), to + 2, y});
  }
}

// The line through a series, as a row of boxes.
void take_line(const Series& series, const Pixels& at, std::vector<Box>& taken) {
  constexpr int kSteps = 24;
  for (std::size_t i = 1; i < series.marks.size(); ++i) {
    const Mark &a = series.marks[i - 1], &b = series.marks[i];
    const double ax = at.x(a.x), bx = at.x(b.x), ay = at.y(a.y), by = at.y(b.y);
    const int steps = std::clamp(static_cast<int>(std::hypot(bx - ax, by - ay) / 6), 1, kSteps);
    for (int k = 0; k < steps; ++k) {
      const double x = std::lerp(ax, bx, (k + 0.5) / steps),
                   y = std::lerp(ay, by, (k + 0.5) / steps);
      taken.push_back({x - 3, y - 3, x + 3, y + 3});
    }
  }
}

constexpr double kFar = 18;  // a label so far from its mark has a line to it

}  // namespace

std::string label_commands(const Panel& panel, const Frame& frame) {
  std::vector<LabelWanted> wanted;
  std::vector<std::string> colours;
  std::vector<Box> taken;
  const Pixels at(panel, frame.box);
  for (const Series& series : panel.series) {
    if (series.joined) take_line(series, at, taken);
    for (const Mark& mark : series.marks) {
      take_mark(mark, at, taken);
      if (mark.label.empty()) continue;
      wanted.push_back({at.x(mark.x), at.y(mark.y), mark.label});
      colours.push_back(series.colour);
    }
  }
  for (const Front& front : panel.fronts) take_front(front, at, frame.box.right, taken);
  const auto places = place_labels(wanted, taken, frame.box, kLabelFont);
  std::string text = "do for [i = 1:999] { unset label i }\nunset arrow\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::hypot(places[i].x - wanted[i].x, places[i].y - wanted[i].y) > kFar) {
      text += "set arrow from " + on_screen(frame, wanted[i].x, wanted[i].y) + " to " +
              on_screen(frame, places[i].x, places[i].y) + " nohead lw 0.5 lc rgb \"" + colours[i] +
              "\"\n";
    }
    text += "set label " + std::to_string(i + 1) + " " + script_text(wanted[i].text) + " at " +
            on_screen(frame, places[i].x, places[i].y) + (places[i].at_left ? " right" : " left") +
            " noenhanced font \"," + script_number(kLabelFont) + "\" tc rgb \"" + colours[i] +
            "\"\n";
  }
  return text;
}

}  // namespace gonio::cli
