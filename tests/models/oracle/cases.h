// The materials that are held against the oracle: every model, with parameters from the mildest to
// the most extreme, and every kind of Fresnel factor.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gonio/engine/material.h"

namespace gonio::testing {

// How sharp the lobe is decides what float64 can promise.
enum class Sharpness : std::uint8_t {
  smooth,   // exponents to 1e3, or the slopes and roughnesses of such a lobe
  sharp,    // exponents to 1e6, roughness to 1e-3
  extreme,  // beyond: measured and reported
};

struct Case {
  std::string name;
  Sharpness sharpness;
  MaterialSpec spec;
};

// The analytic models of the registry, and "sum".
std::vector<std::string> models_with_cases();

// The cases of one model of the registry, or of "sum".
std::vector<Case> cases_of(std::string_view model);

// A lobe from pairs like {"alpha_x", 0.1}, {"f0", {1, .8, .6}}, {"fresnel", "schlick"}.
using Parameters = std::map<std::string, ParameterValue, std::less<>>;
inline ParameterValue number(double v) { return std::vector<double>{v}; }
inline MaterialSpec alone(std::string model, Parameters parameters) {
  return {LobeSpec{std::move(model), std::move(parameters)}, {}, {}};
}

}  // namespace gonio::testing
