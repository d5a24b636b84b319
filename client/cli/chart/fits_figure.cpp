// What represents a measured material: time and bytes against errors.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "client/cli/chart/figures.h"

namespace gonio::cli {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Plot {
  const char *title, *x, *x_label, *y, *y_label;
};
constexpr std::array kPlots{
    Plot{"time, L1", "ns", "ns per evaluation", "l1_all", "relative L1 error"},
    Plot{"size, L1", "bytes", "bytes", "l1_all", "relative L1 error"},
    Plot{"time, L1 where both angles are up to 80 degrees", "ns", "ns per evaluation",
         "l1_below_80", "relative L1 error"},
    Plot{"time, cube roots", "ns", "ns per evaluation", "cbrt_all", "RMS error of cube roots"}};

// The table is what the others are compared with: its own error is 0, or rounding.
bool is_table(const chart::Table& table, std::size_t row) {
  return table.word(row, "verdict") == "measured";
}

// By size, models are too near to one another for all labels: the front's and one table's.
std::string label_of(const chart::Table& table, std::size_t row, const Front& front, bool timed) {
  const std::string& name = table.word(row, "representation");
  if (is_table(table, row) && timed) return name + " (error 0)";
  const std::pair at{table.number(row, "bytes"), table.number(row, "l1_all")};
  if (!timed && std::ranges::find(front, at) == front.end()) return "";
  return is_table(table, row) ? "table (error 0)" : name;
}

Panel panel_of(const chart::Table& table, const Plot& plot) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (!is_table(table, i)) errors.push_back(table.number(i, plot.y));
  }
  const auto [low, high] = log_range(errors, 1.6);
  const auto [least, most] = log_range(numbers_of(table, plot.x), 1.5);
  Panel panel{plot.title, {plot.x_label, least, most}, {plot.y_label, low / 1.5, high}};
  Series models{"", kBlue, Shape::disc}, tables{"", kRed, Shape::square};
  const Front front = front_of(table, plot.x, plot.y);
  const bool timed = std::string_view(plot.x) == "ns";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    Series& series = is_table(table, i) ? tables : models;
    series.marks.push_back({table.number(i, plot.x), timed ? table.number(i, "ns_upper") : kNone,
                            table.number(i, plot.y), kNone, ""});
    series.marks.back().label = label_of(table, i, front, timed);
  }
  panel.series = {models, tables};
  panel.fronts = {front};
  return panel;
}

}  // namespace

Figure fits_figure(const chart::Table& table) {
  Figure figure{"fits", table.title, 640, 440, 2, {}};
  for (const Plot& plot : kPlots) figure.panels.push_back(panel_of(table, plot));
  return figure;
}

}  // namespace gonio::cli
