// Parameter sets drawn from a model's own table, so that a model added to the registry is tested
// without a line here.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "gonio/engine/registry.h"
#include "models/oracle/cases.h"

namespace gonio::testing {

struct Draw {
  std::string name;
  MaterialSpec spec;
};

// The value at a fraction of a parameter's range, along its own scale. A logarithmic scale that
// starts at 0 takes the eight decades below its upper end. No colour multiplier is drawn above 1:
// what gains energy by its own word proves nothing.
inline double at_fraction(const Parameter& p, double t) {
  if (p.quantity == Quantity::amplitude) return std::lerp(p.lower, std::min(p.upper, 1.0), t);
  if (p.scale == Scale::linear) return std::lerp(p.lower, p.upper, t);
  if (t == 0) return p.lower;
  const double from = p.lower > 0 ? p.lower : p.upper * 1e-8;
  return std::clamp(from * std::pow(p.upper / from, t), p.lower, p.upper);
}

// A word for each parameter that takes one.
using Words = std::map<std::string_view, std::string_view>;

// Whether a number has a meaning with these words; those that do not are refused.
inline bool usable_with(const Words& words, const Parameter& p) {
  if (p.used_with.parameter.empty()) return true;
  return std::ranges::count(p.used_with.words, words.at(p.used_with.parameter)) != 0;
}

// Numbers at `fractions` in turn, colours over three channels from `colours` in turn.
inline Parameters draw_parameters(const ModelDescription& model, const Words& words,
                                  const std::vector<double>& fractions,
                                  const std::vector<double>& colours) {
  Parameters parameters;
  std::size_t numbers_drawn = 0, colours_drawn = 0;
  for (const Parameter& p : model.parameters) {
    if (!usable_with(words, p)) continue;
    if (p.type == ParameterType::word) {
      parameters[std::string(p.name)] = std::string(words.at(p.name));
    } else if (p.type == ParameterType::number) {
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

// Every combination of words that the model takes.
inline std::vector<Words> word_choices(const ModelDescription& model) {
  std::vector<Words> choices{{}};
  for (const Parameter& p : model.parameters) {
    if (p.type != ParameterType::word) continue;
    std::vector<Words> more;
    for (const Words& words : choices) {
      for (const std::string_view word : p.words) {
        more.push_back(words);
        more.back()[p.name] = word;
      }
    }
    choices = std::move(more);
  }
  return choices;
}

inline std::string text_of(const Words& words) {
  std::string text;
  for (const auto& [name, word] : words) text += ", " + std::string(name) + " " + std::string(word);
  return text;
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
  for (const Words& words : word_choices(model)) {
    for (const auto& [name, values] : places_in_range()) {
      const std::vector<double> colours = draws.size() % 2 == 0
                                              ? std::vector<double>{1, 0.5, 0, 1}
                                              : std::vector<double>{0.37, 1, 0.62, 0.04};
      draws.push_back(
          {name + text_of(words),
           alone(std::string(model.name), draw_parameters(model, words, values, colours))});
    }
  }
  return draws;
}

// Whether a word has brought in what reflects less than all.
inline bool has_fresnel(const ModelDescription& model, const Words& words) {
  return std::ranges::any_of(model.parameters, [&](const Parameter& p) {
    const Quantity quantity = quantity_of(p, model.role);
    const bool fresnel = quantity == Quantity::reflectance ||
                         quantity == Quantity::refractive_index || quantity == Quantity::extinction;
    return fresnel && !p.used_with.parameter.empty() && usable_with(words, p);
  });
}

// The same with every colour 1 and no Fresnel factor: what these lack of albedo 1, the model loses.
inline std::vector<Draw> white_draws_of(const ModelDescription& model) {
  std::vector<Draw> draws;
  for (const Words& words : word_choices(model)) {
    if (has_fresnel(model, words)) continue;
    for (const auto& [name, values] : places_in_range()) {
      draws.push_back({name + text_of(words),
                       alone(std::string(model.name), draw_parameters(model, words, values, {1}))});
    }
  }
  return draws;
}

}  // namespace gonio::testing
