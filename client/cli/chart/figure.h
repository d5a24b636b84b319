// Figures of speed against accuracy, as data: panels of marks, each mark a choice. figure_script()
// makes a gnuplot script of one. Thread safety: plain values, functions without state.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

// A choice: at (x, y). A bar goes from x to `x_high` (most repetitions are within it), a thin line
// from y to `y_other` (another percentile of the error); NaN: none.
struct Mark {
  double x, x_high, y, y_other;
  std::string label = {};  // beside it, where there is room
};

enum class Shape { none, disc, ring, square, diamond, triangle };

struct Series {
  std::string name;    // in the key; empty: not there
  std::string colour;  // "#1f5faa"
  Shape shape = Shape::disc;
  bool joined = false;  // by a line
  std::vector<Mark> marks = {};
};

using Front = std::vector<std::pair<double, double>>;  // from the left

struct Axis {
  std::string label;
  double low, high;
  bool logarithmic = true;
  bool numbered = true;
};

struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Series> series = {};
  // What no other choice beats: step lines that begin at the top and go on to the right.
  std::vector<Front> fronts = {};
  bool key = false;
  bool only_key = false;  // instead of a plot
};

struct Figure {
  std::string name;                           // of the files, without an extension
  std::string caption;                        // above all panels
  int panel_width = 460, panel_height = 360;  // pixels
  int columns = 1;
  std::vector<Panel> panels = {};
};

// Draws NAME.svg and NAME.png in the folder where gnuplot runs.
std::string figure_script(const Figure& figure);

// Ends of a logarithmic axis: whole powers of ten, or 2 and 5 of them, that hold all numbers above
// 0 with room at both ends.
std::pair<double, double> log_range(const std::vector<double>& numbers, double room);

}  // namespace gonio::cli
