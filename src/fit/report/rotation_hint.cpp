// What anisotropy would explain of data that a fit has left out.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "fit/data/pattern.h"
#include "fit/search/rotation.h"

namespace gonio::fit {
namespace {

// Sizes of a pattern, and how many times what chance makes of it. Where azimuths of incidence
// differ, isotropic data leave 0.01 and less, also of a wrong model; those with alphas of 0.1 and
// 0.4 leave 0.2 to 0.5 of an isotropic lobe. A fit that comes to much less is proof enough of a
// small one.
constexpr double kSuspicious = 0.08, kSuspiciousSigmas = 4;
constexpr double kStrong = 0.2, kStrongSigmas = 5;
constexpr double kBad = 0.05;    // an L1 below needs no advice
constexpr double kBetter = 0.8;  // of the objective: what a turned fit must come to
constexpr double kAlong = 5;     // degrees: as good as along the frame

std::string text(double x, const char* format) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}

// A quarter of a turn swaps the tangents.
std::string turned_by(double azimuth) {
  const double degrees = std::remainder(azimuth, 90.0);
  if (std::abs(degrees) < kAlong) return "along the axes of the data's frame";
  return "with axes turned by about " + text(degrees, "%.0f") + " degrees";
}

// The model's own anisotropic form, its axes free: its rotation and objective on these pairs.
struct Explained {
  double rotation, objective;
};
std::optional<Explained> explained(const SearchInput& input, MaterialSpec spec, const Data& pairs) {
  spec.rotation.reset();
  const auto free = make_form(spec, {true, true});
  if (!free) return std::nullopt;
  const Form form = with_shapes(input.form, *free);
  Options options = input.options;
  options.polish = false;
  const Watch quiet{{}, input.watch.stop};
  const Search search = search_automatic({form, pairs, options, quiet, input.loss});
  if (search.parameters.empty()) return std::nullopt;
  const std::vector<double> unturned(search.parameters.size(), 0);
  const auto parameters = near_turn(form, unturned, search.parameters);
  const Problem problem(form, pairs, input.loss, input.options.cosine);
  return Explained{parameters[*form.rotation_shape],
                   problem.cost(parameters, true, input.watch.stop)};
}

std::optional<std::string> hint(const SearchInput& input, const MaterialSpec& spec,
                                std::span<const double> parameters, const Certificate& report) {
  if (!(report.errors.all.l1 > kBad)) return std::nullopt;
  const Data pairs = subset(input.data, input.options.fit_pairs, input.options.seed);
  const Problem problem(input.form, pairs, input.loss, input.options.cosine);
  const Pattern left = pattern_of(problem, parameters, input.watch.stop);
  const double size = left.anisotropic();
  if (size < std::max(kSuspicious, kSuspiciousSigmas * left.noise)) return std::nullopt;
  if (!has_tangents(input.form)) {
    if (size < std::max(kStrong, kStrongSigmas * left.noise)) return std::nullopt;
    return "the data look anisotropic, " +
           (left.of_one_azimuth() ? "with turned axes" : turned_by(left.degrees())) +
           ": a model with tangents may fit better";
  }
  const Data few = subset(input.data, input.options.scan_pairs, input.options.seed);
  const auto better = explained(input, spec, few);
  const Problem same(input.form, few, input.loss, input.options.cosine);
  const double here = same.cost(parameters, true, input.watch.stop);
  if (!better || !(better->objective < kBetter * here)) return std::nullopt;
  return "the data look anisotropic, " + turned_by(better->rotation) + ": an anisotropic fit" +
         (input.options.anisotropic ? " that finds its rotation" : "") +
         " comes to an objective of " + text(better->objective, "%.2g") + " in place of " +
         text(here, "%.2g");
}

}  // namespace

void add_hint(const SearchInput& input, const MaterialSpec& spec,
              std::span<const double> parameters, Certificate& report) {
  const auto found = hint(input, spec, parameters, report);
  if (found) report.reason += "; " + *found;
}

}  // namespace gonio::fit
