// Truth for test pairs, and how much of an error is not the library's.
#pragma once

#include "models/oracle/run.h"

namespace gonio::testing {

// What is promised holds above this value of f.
inline constexpr double kAbove = 1e-30;

// Whether f passes through 0 between directions, so that a rounding of any parameter counts there.
inline bool crosses_zero(const MaterialSpec& spec) {
  return spec.model && spec.model->model == "oren_nayar";
}

// The parameters of which, at some places, one rounding moves f by more than any bound: eta at the
// critical angle of total reflection (eta < 1), where F has an infinite slope; all of Oren and
// Nayar's, whose full form crosses 0.
inline std::vector<std::string> delicate_parameters(const MaterialSpec& spec) {
  if (!spec.model) return {};
  if (crosses_zero(spec)) return {"rd", "sigma"};
  const auto eta = spec.model->parameters.find("eta");
  if (eta == spec.model->parameters.end()) return {};
  const auto& values = std::get<std::vector<double>>(eta->second);
  const bool total = std::ranges::any_of(values, [](double v) { return v < 1; });
  return total ? std::vector<std::string>{"eta"} : std::vector<std::string>{};
}

// Four times the shift of f, relative to f, that a rounding of these causes. `rounding` is
// relative.
template <class In>
std::vector<double> shift_by_rounding(const MaterialSpec& spec,
                                      const std::vector<DirectionPair<In>>& pairs,
                                      const std::vector<Quad>& truth, double rounding) {
  std::vector<double> unsure;
  for (const std::string& name : delicate_parameters(spec)) {
    unsure.resize(truth.size());
    for (const double factor : {1 - rounding, 1 + rounding}) {
      MaterialSpec shifted = spec;
      for (double& v : std::get<std::vector<double>>(shifted.model->parameters.at(name)))
        v *= factor;
      const std::vector<Quad> moved = oracle_values(Oracle<Quad>(shifted), pairs);
      for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!(truth[i] > kAbove)) continue;
        const auto shift = static_cast<double>((moved[i] - truth[i]) / truth[i]);
        unsure[i] = std::max(unsure[i], 4 * std::abs(shift));
      }
    }
  }
  return unsure;
}

// What is not the library's part of an error: only where a rounding is magnified, near the places
// named above.
template <class In>
std::vector<double> unsure_of(const MaterialSpec& spec, Precision precision,
                              const std::vector<DirectionPair<In>>& pairs,
                              const std::vector<Quad>& truth) {
  if (precision == Precision::fast && !crosses_zero(spec)) return {};
  const double rounding = precision == Precision::fast ? 0x1p-24 : 0x1p-52;
  std::vector<double> unsure = shift_by_rounding(spec, pairs, truth, rounding);
  for (double& shift : unsure) shift = shift > 16 * rounding ? shift : 0;
  return unsure;
}

// Truth, or NaN where a pair is nearer to the horizon than the bounds reach.
template <class In>
std::vector<Quad> truth_of(const MaterialSpec& spec, const std::vector<DirectionPair<In>>& pairs) {
  std::vector<Quad> truth = oracle_values(Oracle<Quad>(spec), pairs);
  const std::size_t channels = truth.size() / pairs.size();
  const double cosine = 1.001 * ErrorBound{}.cosine;  // of directions off unit length, too
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto& pair = pairs[i / channels];
    const double least = std::min(pair.wi[2], pair.wo[2]);
    if (least > 0 && least < cosine) truth[i] = std::numeric_limits<double>::quiet_NaN();
  }
  return truth;
}

}  // namespace gonio::testing
