#include "select/error/rounding.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "gonio/engine/registry.h"

namespace gonio::select {
namespace {

// Rounds by way of text, so that writing and reading the number gives it again.
double to_digits(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.*g", digits, x);
  return std::strtod(text, nullptr);
}

void round_lobe(LobeSpec& lobe, int digits) {
  for (const Parameter& p : (*find_model(lobe.model))->parameters) {
    const auto found = lobe.parameters.find(p.name);
    if (found == lobe.parameters.end()) continue;
    auto* numbers = std::get_if<std::vector<double>>(&found->second);
    if (numbers == nullptr) continue;
    for (double& x : *numbers) x = std::clamp(to_digits(x, digits), p.lower, p.upper);
  }
}

}  // namespace

MaterialSpec rounded(const MaterialSpec& spec, int digits) {
  MaterialSpec result = spec;
  if (result.model) round_lobe(*result.model, digits);
  if (result.diffuse) round_lobe(*result.diffuse, digits);
  for (LobeSpec& lobe : result.specular) round_lobe(lobe, digits);
  if (result.rotation) *result.rotation = to_digits(*result.rotation, digits);
  return result;
}

}  // namespace gonio::select
