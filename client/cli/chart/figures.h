// The figures of a chart's tables. Thread safety: functions without state.
#pragma once

#include <vector>

#include "chart/table.h"
#include "client/cli/chart/figure.h"

namespace gonio::cli {

// Of one table, by its name; none of one that only holds numbers.
std::vector<Figure> figures_of(const chart::Table& table);

// What several of them have in common.
inline constexpr const char* kBlue = "#1f5faa";
inline constexpr const char* kGreen = "#2a8a57";
inline constexpr const char* kAmber = "#d08a1d";
inline constexpr const char* kRed = "#c0504d";
inline constexpr const char* kPurple = "#7d4ba0";
inline constexpr const char* kGrey = "#6b7680";

inline constexpr const char* kInk = "#333333";

Figure models_figure(const chart::Table& table);
Figure fits_figure(const chart::Table& table);
Figure fresnel_figure(const chart::Table& table);
Figure fresnel_angles_figure(const chart::Table& table);
Figure printed_figure(const chart::Table& table);
Figure wire_figure(const chart::Table& table);
Figure directions_figure(const chart::Table& table);
Figure sampling_figure(const chart::Table& table);
Figure resolution_figure(const chart::Table& table);

// A panel that only says what marks mean; looks have a name, a colour and a shape.
template <class Looks>
Panel key_panel(const Looks& looks) {
  Panel panel{"", {"", 0, 1, false}, {"", 0, 1, false}};
  for (const auto& look : looks) panel.series.push_back({look.name, look.colour, look.shape});
  panel.key = panel.only_key = true;
  return panel;
}

// All numbers of a column.
std::vector<double> numbers_of(const chart::Table& table, std::string_view column);
// The Pareto front of two columns, of all rows.
Front front_of(const chart::Table& table, std::string_view x, std::string_view y);

}  // namespace gonio::cli
