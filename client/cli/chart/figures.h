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

Figure models_figure(const chart::Table& table);

}  // namespace gonio::cli
