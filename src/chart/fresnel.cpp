// Fresnel's term: a constant, Schlick's approximation and the exact one.
#include <array>
#include <cmath>
#include <numbers>

#include "chart/cases.h"
#include "chart/chart.h"
#include "chart/common.h"
#include "engine/truth/truth.h"
#include "schema/presets.h"

namespace gonio::chart {
namespace {

using Numbers = std::vector<double>;

struct Substance {
  std::string name;
  Numbers eta, k;  // without k: a dielectric
};

std::vector<Substance> substances() {
  std::vector<Substance> all{{"water", {1.333}, {}}, {"glass", {1.5}, {}}, {"diamond", {2.42}, {}}};
  for (const auto& metal : presets::kConductors) {
    if (metal.name == "silver" || metal.name == "iron") continue;  // like aluminium, like chromium
    all.push_back({std::string(metal.name),
                   {metal.eta.begin(), metal.eta.end()},
                   {metal.k.begin(), metal.k.end()}});
  }
  return all;
}

// The reflectance at normal incidence.
Numbers reflectance_of(const Substance& substance) {
  Numbers f0;
  for (std::size_t c = 0; c < substance.eta.size(); ++c) {
    const double eta = substance.eta[c], k = substance.k.empty() ? 0 : substance.k[c];
    f0.push_back(((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k));
  }
  return f0;
}

// A lobe with the term in question.
Material lobe_with(LobeSpec lobe) {
  lobe.model = "cook_torrance";
  lobe.parameters["m"] = Numbers{0.3};
  return *Material::create(alone(std::move(lobe)));
}

Material constant(const Substance& substance) {
  return lobe_with({"", {{"fresnel", std::string("none")}, {"scale", reflectance_of(substance)}}});
}
Material schlick(const Substance& substance) {
  return lobe_with({"", {{"f0", reflectance_of(substance)}}});
}
Material exact(const Substance& substance) {
  if (substance.k.empty()) return lobe_with({"", {{"eta", substance.eta}}});
  return lobe_with({"", {{"eta", substance.eta}, {"k", substance.k}}});
}

struct Form {
  const char* name;
  Material (*make)(const Substance&);
};
constexpr std::array kForms{Form{"constant", &constant}, Form{"schlick", &schlick},
                            Form{"exact", &exact}};

constexpr double kDegree = std::numbers::pi / 180;

// A pair in mirror directions, so that h = n and h.k is the cosine of the angle.
struct MirrorPair {
  std::array<float, 3> wi, wo;
  explicit MirrorPair(double degrees) {
    const auto s = static_cast<float>(std::sin(degrees * kDegree)),
               c = static_cast<float>(std::cos(degrees * kDegree));
    wi = {s, 0, c}, wo = {-s, 0, c};
  }
};

// The ratio of a lobe's f there in the fast precision to that of another lobe in long double, for
// all channels.
std::vector<double> ratios(const Material& material, const Truth& truth, double degrees) {
  const MirrorPair pair(degrees);
  const auto channels = static_cast<std::size_t>(material.channels());
  std::vector<float> f(channels);
  evaluate(material,
           Batch<float, float>{Directions<float>::interleaved(pair.wi.data()),
                               Directions<float>::interleaved(pair.wo.data()), 1,
                               Values<float>::interleaved(f.data(), material.channels()), nullptr},
           best_isa());
  std::vector<long double> right(channels);
  truth.evaluate({pair.wi[0], pair.wi[1], pair.wi[2]}, {pair.wo[0], pair.wo[1], pair.wo[2]}, right);
  std::vector<double> ratio;
  for (std::size_t c = 0; c < channels; ++c) ratio.push_back(static_cast<double>(f[c] / right[c]));
  return ratio;
}

// The errors over angles up to 89 degrees and all channels.
struct FresnelErrors {
  double worst = 0, mean = 0;  // the mean weighs by cosine and solid angle
};
FresnelErrors errors_of(const Material& material, const Truth& truth) {
  FresnelErrors errors;
  double weights = 0;
  for (int half = 0; half <= 2 * 89; ++half) {
    const double degrees = 0.5 * half;
    const double weight = std::sin(2 * degrees * kDegree);
    for (const double ratio : ratios(material, truth, degrees)) {
      const double error = std::abs(ratio - 1);
      errors.worst = std::max(errors.worst, error);
      errors.mean += weight * error, weights += weight;
    }
  }
  errors.mean /= weights;
  return errors;
}

struct Choice {
  std::string substance, form;
  Material material;
  FresnelErrors errors;
};

std::vector<Choice> all_choices() {
  std::vector<Choice> choices;
  for (const Substance& substance : substances()) {
    const Truth truth(exact(substance));
    for (const Form& form : kForms) {
      const Material material = form.make(substance);
      choices.push_back({substance.name, form.name, material, errors_of(material, truth)});
    }
  }
  return choices;
}

Table empty_table() {
  Table table{"fresnel",
              "Fresnel's term: ns per evaluation of a cook_torrance lobe against the exact term",
              {{"substance", "", "seen from air"},
               {"form", "", "constant: the reflectance at normal incidence"}},
              {}};
  add_time_columns(table, "ns", "ns", "time of one evaluation, fast, the best instruction set");
  table.columns.push_back(
      {"error_worst", "1", "the largest relative error for angles up to 89 degrees"});
  table.columns.push_back({"error_mean", "1", "the mean, weighed by cosine and solid angle"});
  return table;
}

}  // namespace

Result<Table> chart_fresnel(const Options& options) {
  const auto pairs = std::make_shared<timing::Pairs>(timing::kTimedPairs);
  const std::vector<Choice> choices = all_choices();
  std::vector<timing::Runner> runners;
  for (const Choice& choice : choices)
    runners.push_back(timing::evaluation(pairs, choice.material, Precision::fast, best_isa()));
  const auto seconds = timing::race(runners, options.effort, options.stop);
  if (is_over(options)) return was_cancelled();
  Table table = empty_table();
  for (std::size_t i = 0; i < choices.size(); ++i) {
    std::vector<Cell> row{choices[i].substance, choices[i].form};
    add_time_cells(row, scaled(seconds[i], 1e9));
    row.emplace_back(choices[i].errors.worst);
    row.emplace_back(choices[i].errors.mean);
    table.rows.push_back(std::move(row));
  }
  add_front(table, "ns", "error_worst", "substance");
  show(options, 1);
  return table;
}

Table chart_fresnel_angles() {
  Table table{"fresnel_angles",
              "Schlick's approximation by angle: reflectance over the exact one, less 1",
              {{"substance", "", "seen from air"},
               {"channel", "1", "0: red, or all; 1: green; 2: blue"},
               {"theta", "deg", "between light and half-vector"},
               {"error", "1", "relative"}},
              {}};
  for (const Substance& substance : substances()) {
    const Truth truth(exact(substance));
    const Material material = schlick(substance);
    for (int degrees = 0; degrees <= 89; ++degrees) {
      const auto ratio = ratios(material, truth, degrees);
      for (std::size_t c = 0; c < ratio.size(); ++c) {
        table.rows.push_back(
            {substance.name, static_cast<double>(c), static_cast<double>(degrees), ratio[c] - 1});
      }
    }
  }
  return table;
}

}  // namespace gonio::chart
