// The part of a gnuplot script that draws one panel. Thread safety: functions without state.
#pragma once

#include <string>

#include "client/cli/chart/figure.h"
#include "client/cli/chart/panel/labels.h"

namespace gonio::cli {

inline constexpr double kLabelFont = 9.5;

// Where a panel's plot is on the page, in pixels from the lower left.
struct Frame {
  Box box;
  double width, height;  // of the page
  bool x_label = true, y_label = true;
};

// The panel's numbers as blocks, "$NAME_0" for the first series.
std::string data_blocks(const Panel& panel, const std::string& name);
// What draws them, inside a multiplot.
std::string panel_commands(const Panel& panel, const Frame& frame, const std::string& name);

// Of the labels alone.
std::string label_commands(const Panel& panel, const Frame& frame);

// As scripts have them: a number, and quoted text.
std::string script_number(double x);
std::string script_text(const std::string& text);

}  // namespace gonio::cli
