// Strategies of sampling: a panel a model.
#include <algorithm>
#include <array>
#include <map>

#include "client/cli/chart/figures.h"

namespace gonio::cli {
namespace {

struct Look {
  std::string_view strategy;
  double theta;
  const char* name;
  const char* colour;
  Shape shape;
};
constexpr std::array kLooks{Look{"gonio", 30, "gonio's strategy, 30 deg", kBlue, Shape::disc},
                            Look{"gonio", 75, "gonio's strategy, 75 deg", kBlue, Shape::square},
                            Look{"cosine", 30, "by the cosine, 30 deg", kAmber, Shape::disc},
                            Look{"cosine", 75, "by the cosine, 75 deg", kAmber, Shape::square},
                            Look{"textbook", 30, "a textbook's loop, 30 deg", kRed, Shape::disc},
                            Look{"textbook", 75, "a textbook's loop, 75 deg", kRed, Shape::square}};
constexpr double kLow = 1e-6, kHigh = 1e4;

void add_mark(const chart::Table& table, std::size_t i, Panel& panel) {
  const auto* look = std::ranges::find_if(kLooks, [&](const Look& l) {
    return l.strategy == table.word(i, "strategy") && l.theta == table.number(i, "theta");
  });
  if (look == kLooks.end()) return;
  panel.series.push_back({"",
                          look->colour,
                          look->shape,
                          false,
                          {{table.number(i, "ns"), table.number(i, "ns_upper"),
                            table.number(i, "variance"), table.number(i, "variance_upper")}}});
}

}  // namespace

Figure sampling_figure(const chart::Table& table) {
  Figure figure{
      "sampling",
      "Sampling, by model: time of a sample against the variance of the weights over their "
      "mean's square",
      330,
      270,
      4,
      {}};
  const auto [low, high] = log_range(numbers_of(table, "ns"), 1.2);
  for (std::size_t i = 0; i < table.rows.size();) {
    const std::string& model = table.word(i, "model");
    Panel panel{model, {"ns a sample", low, high}, {"variance", kLow, kHigh}};
    std::map<std::string, Front> fronts;  // one an angle
    for (; i < table.rows.size() && table.word(i, "model") == model; ++i) {
      add_mark(table, i, panel);
      if (table.number(i, "front") == 1)
        fronts[table.word(i, "group")].emplace_back(table.number(i, "ns"),
                                                    table.number(i, "variance"));
    }
    for (auto& [group, front] : fronts) {
      std::ranges::sort(front);
      panel.fronts.push_back(front);
    }
    figure.panels.push_back(std::move(panel));
  }
  figure.panels.push_back(key_panel(kLooks));
  return figure;
}

}  // namespace gonio::cli
