// Fresnel's term and what publications print.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "client/cli/chart/figures.h"

namespace gonio::cli {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// By substance, in the order of the table.
constexpr std::array kColours{"#56b4e9", kBlue, kInk, "#d0a21d", kRed, kPurple, "#8c6d4f", kGreen};

std::vector<std::string> words_of(const chart::Table& table, std::string_view column) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (std::ranges::find(words, table.word(i, column)) == words.end())
      words.push_back(table.word(i, column));
  }
  return words;
}

// One channel of one substance by angle, its name where it is farthest from 0.
Series angles_of(const chart::Table& table, const std::string& substance, double channel,
                 const char* colour) {
  Series series{"", colour, Shape::none, true};
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.word(i, "substance") != substance || table.number(i, "channel") != channel) continue;
    series.marks.push_back(
        {table.number(i, "theta"), kNone, 100 * table.number(i, "error"), kNone});
    if (std::abs(series.marks.back().y) > std::abs(series.marks[farthest].y))
      farthest = series.marks.size() - 1;
  }
  if (!series.marks.empty()) series.marks[farthest].label = substance;
  return series;
}

}  // namespace

Figure fresnel_figure(const chart::Table& table) {
  Figure figure{
      "fresnel", "Fresnel's term in a lobe, largest error for angles up to 89 degrees (line: mean)",
      480,       400,
      2,         {}};
  const double most = log_range(numbers_of(table, "ns"), 1.05).second;
  const Axis time{"ns per evaluation, three channels", 0, most, false};
  // Exact values err by less than 1e-6 and are drawn at the bottom.
  Panel dielectrics{"dielectrics", time, {"relative error", 1e-3, 2}}, metals = dielectrics;
  metals.title = "metals";
  const auto substances = words_of(table, "substance");
  for (std::size_t s = 0; s < substances.size(); ++s) {
    Series series{"", kColours[s % kColours.size()], Shape::disc, true};
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      if (table.word(i, "substance") != substances[s]) continue;
      series.marks.push_back({table.number(i, "ns"), table.number(i, "ns_upper"),
                              table.number(i, "error_worst"), table.number(i, "error_mean"),
                              table.word(i, "form") == "schlick" ? substances[s] : ""});
    }
    Panel& panel = s < 3 ? dielectrics : metals;
    if (panel.series.empty()) {
      series.marks.front().label = "constant";
      series.marks.back().label = "exact (below 1e-6)";
    }
    panel.series.push_back(std::move(series));
  }
  figure.panels = {dielectrics, metals};
  return figure;
}

Figure fresnel_angles_figure(const chart::Table& table) {
  Figure figure{
      "fresnel_angles", "Schlick's approximation: how far off, by angle", 620, 420, 1, {}};
  Panel panel{"metals in green; reflectance at normal incidence is exact",
              {"degrees between light and half-vector", 0, 100, false},
              {"error in %", -30, 40, false}};
  const auto substances = words_of(table, "substance");
  for (std::size_t s = 0; s < substances.size(); ++s) {
    const char* colour = kColours[s % kColours.size()];
    Series green = angles_of(table, substances[s], 1, colour);
    if (green.marks.empty()) green = angles_of(table, substances[s], 0, colour);
    panel.series.push_back(std::move(green));
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure printed_figure(const chart::Table& table) {
  Figure figure{
      "printed", "What publications print: relative error of f, both angles up to 80 degrees",
      760,       400,
      1,         {}};
  Panel panel{"from the median to the worst pair",
              {"relative error", 1e-4, 1e6},
              {"", 0, static_cast<double>(table.rows.size()) / 2, false, false}};
  double at = static_cast<double>(table.rows.size()) / 2 - 0.5;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (table.word(i, "form") != "printed") continue;
    const double improper = table.number(i, "improper");
    std::string label = table.word(i, "what");
    if (improper > 0) {
      label +=
          ": negative or NaN for " +
          std::to_string(std::lround(100 * improper / (improper + table.number(i, "checked")))) +
          " %";
    }
    panel.series.push_back(
        {"",
         improper > 0 ? kRed : kBlue,
         Shape::disc,
         false,
         {{table.number(i, "error_worst"), table.number(i, "error_median"), at, kNone, label}}});
    at -= 1;
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace gonio::cli
