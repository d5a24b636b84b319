// Parameter sets drawn from a model's own table, so that a model added to the registry is tested
// without a line here.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "engine/registry.h"
#include "models/cases.h"

namespace gonio::testing {

struct Draw {
  std::string name;
  MaterialSpec spec;
};

// The value at a fraction of a parameter's range, along its own scale. A logarithmic scale that
// starts at 0 takes the eight decades below its upper end. No colour multiplier is drawn above 1:
// what gains energy by its own word proves nothing.
inline double at_fraction(const Parameter& p, double t) {
  if (p.name == "scale") return std::lerp(p.lower, std::min(p.upper, 1.0), t);
  if (p.scale == Scale::linear) return std::lerp(p.lower, p.upper, t);
  if (t == 0) return p.lower;
  const double from = p.lower > 0 ? p.lower : p.upper * 1e-8;
  return std::clamp(from * std::pow(p.upper / from, t), p.lower, p.upper);
}

// Whether a parameter has a meaning with a Fresnel word; those that do not are refused.
inline bool used_with(std::string_view word, std::string_view parameter) {
  if (parameter == "f0") return word == "schlick";
  if (parameter == "eta") return word == "dielectric" || word == "conductor";
  if (parameter == "k") return word == "conductor";
  return true;
}

// Numbers at `fractions` in turn, colours over three channels from `colours` in turn.
inline Parameters draw_parameters(const ModelDescription& model, std::string_view word,
                                  const std::vector<double>& fractions,
                                  const std::vector<double>& colours) {
  Parameters parameters;
  std::size_t numbers_drawn = 0, colours_drawn = 0;
  for (const Parameter& p : model.parameters) {
    if (!used_with(word, p.name)) continue;
    if (p.kind == Kind::word) {
      if (p.name == "fresnel") parameters[std::string(p.name)] = std::string(word);
    } else if (p.kind == Kind::number) {
      parameters[std::string(p.name)] =
          number(at_fraction(p, fractions[numbers_drawn++ % fractions.size()]));
    } else {
      std::vector<double> values;
      for (std::size_t c = 0; c < 3; ++c) {
        values.push_back(at_fraction(p, colours[(colours_drawn + c) % colours.size()]));
      }
      ++colours_drawn;
      parameters[std::string(p.name)] = values;
    }
  }
  return parameters;
}

// The words of the parameter `fresnel`, or one empty word.
inline std::vector<std::string_view> fresnel_words(const ModelDescription& model) {
  for (const Parameter& p : model.parameters) {
    if (p.name == "fresnel") return {p.words.begin(), p.words.end()};
  }
  return {""};
}

struct Fractions {
  std::string name;
  std::vector<double> values;
};

// Both ends, the middle, one-sided (anisotropic) and random places of every range.
inline std::vector<Fractions> places_in_range() {
  std::mt19937 random(5);
  const auto any = [&random] { return std::uniform_real_distribution<double>(0, 1)(random); };
  return {{"lower end", {0}},
          {"upper end", {1}},
          {"middle", {0.5}},
          {"anisotropic", {0.2, 0.8}},
          {"anisotropic, near degenerate", {1, 0}},
          {"random", {any(), any(), any()}},
          {"random too", {any(), any(), any()}}};
}

inline std::vector<Draw> draws_of(const ModelDescription& model) {
  std::vector<Draw> draws;
  for (const std::string_view word : fresnel_words(model)) {
    for (const auto& [name, values] : places_in_range()) {
      const std::vector<double> colours = draws.size() % 2 == 0
                                              ? std::vector<double>{1, 0.5, 0, 1}
                                              : std::vector<double>{0.37, 1, 0.62, 0.04};
      draws.push_back(
          {name + (word.empty() ? "" : ", fresnel " + std::string(word)),
           alone(std::string(model.name), draw_parameters(model, word, values, colours))});
    }
  }
  return draws;
}

// The same with every colour 1 and no Fresnel factor: what these lack of albedo 1, the model loses.
inline std::vector<Draw> white_draws_of(const ModelDescription& model) {
  const std::string_view word = fresnel_words(model).front();
  std::vector<Draw> draws;
  for (const auto& [name, values] : places_in_range()) {
    draws.push_back(
        {name, alone(std::string(model.name), draw_parameters(model, word, values, {1}))});
  }
  return draws;
}

}  // namespace gonio::testing
