// A measured table in fewer cells.
#include <array>
#include <limits>

#include "client/cli/chart/figures.h"

namespace gonio::cli {

Figure resolution_figure(const chart::Table& table) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Figure figure{"resolution", table.title, 760, 460, 1, {}};
  const auto [low, high] = log_range(numbers_of(table, "bytes"), 1.6);
  Panel panel{"cells of theta_h x theta_d x phi_d; the full table has the error 0",
              {"bytes", low, high},
              {"relative L1 error", 5e-3, 1}};
  Series linear{"interpolated", kBlue, Shape::disc}, nearest{"nearest cell", kRed, Shape::ring};
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const bool is_linear = table.word(i, "interpolation") == "linear";
    (is_linear ? linear : nearest)
        .marks.push_back({table.number(i, "bytes"), kNone, table.number(i, "l1_all"), kNone,
                          is_linear ? table.word(i, "cells") : ""});
  }
  panel.series = {linear, nearest};
  panel.fronts = {front_of(table, "bytes", "l1_all")};
  panel.key = true;
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace gonio::cli
