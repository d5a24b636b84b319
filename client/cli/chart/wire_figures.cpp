// The wire: calls by size and form, and the types that travel.
#include <algorithm>
#include <array>
#include <limits>

#include "client/cli/chart/figures.h"
#include "client/cli/output/numbers.h"

namespace gonio::cli {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Look {
  std::string_view name;
  const char* key;
  const char* colour;
  Shape shape;
};
constexpr std::array kForms{Look{"pairs", "pairs, float32", kBlue, Shape::disc},
                            Look{"float64", "pairs, float64", kRed, Shape::square},
                            Look{"grid", "grid", kGreen, Shape::diamond}};

// "64 k", "1 M".
std::string short_count(double pairs) {
  if (pairs >= 1 << 20) return shortest(pairs / (1 << 20)) + " M";
  if (pairs >= 1024) return shortest(pairs / 1024) + " k";
  return shortest(pairs);
}

std::string label_of(const chart::Table& table, std::size_t i) {
  const std::string pairs = short_count(table.number(i, "pairs"));
  if (table.word(i, "call") == "unary") return pairs;
  return pairs + " in " + short_count(table.number(i, "chunk"));
}

}  // namespace

Figure wire_figure(const chart::Table& table) {
  Figure figure{"wire", "The wire: latency of a call against time a pair", 680, 440, 1, {}};
  const auto [low, high] = log_range(numbers_of(table, "us"), 1.5);
  const auto [least, most] = log_range(numbers_of(table, "ns_a_pair"), 1.5);
  Panel panel{"labels: pairs of a call, or of a stream in chunks",
              {"microseconds until all is answered", low, high},
              {"ns a pair", least, most}};
  for (const Look& look : kForms) {
    Series series{look.key, look.colour, look.shape};
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      if (table.word(i, "form") != look.name) continue;
      series.marks.push_back({table.number(i, "us"), table.number(i, "us_upper"),
                              table.number(i, "ns_a_pair"), kNone, label_of(table, i)});
    }
    panel.series.push_back(std::move(series));
  }
  panel.fronts = {front_of(table, "us", "ns_a_pair")};
  panel.key = true;
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure directions_figure(const chart::Table& table) {
  constexpr std::array kColours{kBlue, kGreen, kRed};
  Figure figure{"directions",
                "Types on the wire: bytes a pair of three channels against error, for lobes of ggx",
                680,
                420,
                1,
                {}};
  Panel panel{"to f at the directions before rounding: 99.9th percentile (line: to the worst)",
              {"bytes a pair", 0, 90, false},
              {"relative error", 1e-16, 1}};
  std::size_t group = 0;
  for (std::size_t i = 0; i < table.rows.size(); ++group) {
    const std::string& material = table.word(i, "material");
    Series series{"", kColours[group % kColours.size()], Shape::disc, true};
    for (; i < table.rows.size() && table.word(i, "material") == material; ++i) {
      series.marks.push_back({table.number(i, "bytes"), kNone, table.number(i, "error_999"),
                              table.number(i, "error_worst")});
    }
    series.marks.front().label = "float32, " + material;
    panel.series.push_back(std::move(series));
  }
  auto& lowest = panel.series.front().marks;
  if (lowest.size() == 3) {
    lowest[1].label = "float32 directions, float64 values";
    lowest[2].label = "float64";
  }
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace gonio::cli
