#include "client/cli/chart/figures.h"

#include <algorithm>
#include <array>

#include "chart/front.h"

namespace gonio::cli {
namespace {

struct Drawn {
  std::string_view table;
  Figure (*figure)(const chart::Table&);
};
constexpr std::array kDrawn{
    Drawn{"models", models_figure},         Drawn{"fits", fits_figure},
    Drawn{"fresnel", fresnel_figure},       Drawn{"fresnel_angles", fresnel_angles_figure},
    Drawn{"printed", printed_figure},       Drawn{"wire", wire_figure},
    Drawn{"directions", directions_figure}, Drawn{"sampling", sampling_figure},
    Drawn{"resolution", resolution_figure}};

}  // namespace

std::vector<Figure> figures_of(const chart::Table& table) {
  const auto* drawn = std::ranges::find(kDrawn, table.name, &Drawn::table);
  if (drawn == kDrawn.end() || table.rows.empty()) return {};
  return {drawn->figure(table)};
}

std::vector<double> numbers_of(const chart::Table& table, std::string_view column) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < table.rows.size(); ++i) numbers.push_back(table.number(i, column));
  return numbers;
}

Front front_of(const chart::Table& table, std::string_view x, std::string_view y) {
  const auto costs = numbers_of(table, x), errors = numbers_of(table, y);
  std::vector<chart::Tradeoff> choices;
  for (std::size_t i = 0; i < costs.size(); ++i) choices.push_back({costs[i], errors[i]});
  const std::vector<bool> is_on = chart::on_front(choices);
  Front front;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if (is_on[i]) front.emplace_back(costs[i], errors[i]);
  }
  std::ranges::sort(front);
  return front;
}

}  // namespace gonio::cli
