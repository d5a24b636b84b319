#include "client/cli/chart/figures.h"

#include <algorithm>

#include "chart/front.h"

namespace gonio::cli {
namespace {

// What is drawn of a table, and the columns that this takes: a server may be of another version.
struct Drawn {
  std::string_view table;
  Figure (*figure)(const chart::Table&);
  std::vector<std::string_view> words, numbers;
};

const std::vector<Drawn>& all_drawn() {
  static const std::vector<Drawn> kAll{
      {"models",
       models_figure,
       {"model", "precision", "instruction_set"},
       {"ns", "ns_upper", "error_worst", "error_999", "front"}},
      {"fits",
       fits_figure,
       {"representation", "verdict"},
       {"ns", "ns_upper", "bytes", "l1_all", "l1_below_80", "cbrt_all"}},
      {"fresnel",
       fresnel_figure,
       {"substance", "form"},
       {"ns", "ns_upper", "error_worst", "error_mean"}},
      {"fresnel_angles", fresnel_angles_figure, {"substance"}, {"channel", "theta", "error"}},
      {"printed",
       printed_figure,
       {"what", "form"},
       {"error_worst", "error_median", "checked", "improper"}},
      {"wire", wire_figure, {"form", "call"}, {"pairs", "chunk", "us", "us_upper", "ns_a_pair"}},
      {"directions",
       directions_figure,
       {"material", "types"},
       {"bytes", "error_999", "error_worst"}},
      {"sampling",
       sampling_figure,
       {"model", "strategy", "group"},
       {"theta", "ns", "ns_upper", "variance", "variance_upper", "front"}},
      {"resolution", resolution_figure, {"cells", "interpolation"}, {"bytes", "l1_all"}}};
  return kAll;
}

bool has(const chart::Table& table, const std::vector<std::string_view>& names, bool words) {
  return std::ranges::all_of(names, [&](std::string_view name) {
    const auto found = std::ranges::find(table.columns, name, &chart::Column::name);
    return found != table.columns.end() && found->unit.empty() == words;
  });
}

}  // namespace

std::vector<Figure> figures_of(const chart::Table& table) {
  for (const Drawn& drawn : all_drawn()) {
    if (drawn.table != table.name || table.rows.empty()) continue;
    if (has(table, drawn.words, true) && has(table, drawn.numbers, false))
      return {drawn.figure(table)};
  }
  return {};
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
