// Models by precision and instruction set: a panel a model.
#include <algorithm>
#include <array>
#include <string_view>

#include "client/cli/chart/figures.h"

namespace gonio::cli {
namespace {

// One colour an instruction set; a shape for each precision.
struct Look {
  std::string_view precision, isa;
  const char* label;  // beside the first of its kind
  const char* name;   // in the key
  const char* colour;
  Shape shape;
};
constexpr std::array kLooks{
    Look{"fast", "avx512", "fast", "fast, AVX-512", kBlue, Shape::disc},
    Look{"fast", "avx2", "", "fast, AVX2", kGreen, Shape::disc},
    Look{"fast", "baseline", "", "fast, plain x86-64", kAmber, Shape::disc},
    Look{"reference", "avx512", "reference", "reference, AVX-512", kBlue, Shape::square},
    Look{"reference", "avx2", "", "reference, AVX2", kGreen, Shape::square},
    Look{"reference", "baseline", "", "reference, plain x86-64", kAmber, Shape::square},
    Look{"float", "scalar", "loop", "scalar loop, float32", kRed, Shape::ring},
    Look{"double", "scalar", "", "scalar loop, float64", kRed, Shape::diamond},
};

constexpr double kErrorLow = 1e-17, kErrorHigh = 10;

}  // namespace

Figure models_figure(const chart::Table& table) {
  Figure figure{"models",
                "Speed against accuracy, by model: time of one evaluation in RGB, and the worst "
                "relative error over hard pairs (line: down to the 99.9th percentile)",
                330,
                270,
                4,
                {}};
  std::vector<double> times;
  for (std::size_t i = 0; i < table.rows.size(); ++i) times.push_back(table.number(i, "ns"));
  const auto [low, high] = log_range(times, 1.2);
  for (std::size_t i = 0; i < table.rows.size();) {
    const std::string& model = table.word(i, "model");
    Panel panel{model, {"ns per evaluation", low, high}, {"relative error", kErrorLow, kErrorHigh}};
    Front front;
    for (; i < table.rows.size() && table.word(i, "model") == model; ++i) {
      const auto* look = std::ranges::find_if(kLooks, [&](const Look& l) {
        return l.precision == table.word(i, "precision") &&
               l.isa == table.word(i, "instruction_set");
      });
      if (look == kLooks.end()) continue;
      const double ns = table.number(i, "ns"), error = table.number(i, "error_worst");
      panel.series.push_back(
          {"",
           look->colour,
           look->shape,
           false,
           {{ns, table.number(i, "ns_upper"), error, table.number(i, "error_999"), look->label}}});
      if (table.number(i, "front") == 1) front.emplace_back(ns, error);
    }
    std::ranges::sort(front);
    panel.fronts = {front};
    figure.panels.push_back(std::move(panel));
  }
  figure.panels.push_back(key_panel(kLooks));
  return figure;
}

}  // namespace gonio::cli
