// What anisotropy would explain of data that a fit has left out.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "fit/basis.h"
#include "fit/metrics.h"
#include "fit/pattern.h"
#include "fit/rotation.h"
#include "gonio/engine/registry.h"

namespace gonio::fit {
namespace {

// Residuals of isotropic materials, of wrong models too, are below a tenth where azimuths of
// incidence differ; those of brushed metal fitted by an isotropic lobe are a half.
constexpr double kStrong = 0.25, kSigmas = 6;
constexpr double kBad = 0.05;    // an L1 below needs no advice
constexpr double kBetter = 0.8;  // of the L1: what a turned fit must come to
constexpr double kAlong = 5;     // degrees: as good as along the frame

std::string text(double x, const char* format) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}

std::string turned_by(double degrees) {
  if (std::abs(degrees) < kAlong) return "along the tangents";
  return "with axes turned by about " + text(degrees, "%.0f") + " degrees";
}

bool has_tangents(const Form& form) {
  return std::any_of(form.lobes.begin(), form.lobes.end(), [](const FormLobe& lobe) {
    return (*find_model(lobe.words.model))->has_tangents();
  });
}

// The model's own anisotropic form, its axes free, on the scan's pairs: its rotation and L1.
struct Explained {
  double rotation, l1;
};
std::optional<Explained> explained(const SearchInput& input, MaterialSpec spec) {
  spec.rotation.reset();
  const auto form = make_form(spec, {true, true});
  if (!form) return std::nullopt;
  const Data pairs = subset(input.data, input.options.scan_pairs, input.options.seed);
  Options options = input.options;
  options.polish = false;
  const Watch quiet{{}, input.watch.stop};
  const SearchInput small{*form, pairs, options, quiet, input.loss};
  const Search search = search_automatic(small);
  if (search.parameters.empty()) return std::nullopt;
  const auto shapes =
      near_turn(*form, std::vector<double>(search.parameters.size(), 0), search.parameters);
  const auto material = Material::create(to_material(*form, search.parameters, pairs.channels));
  return Explained{shapes[*form->rotation_shape], compare(*material, pairs, 0).errors.all.l1};
}

std::optional<std::string> hint(const SearchInput& input, const MaterialSpec& spec,
                                const MaterialSpec& fitted, const Certificate& report) {
  if (!(report.errors.all.l1 > kBad)) return std::nullopt;
  const Data pairs = subset(input.data, input.options.fit_pairs, input.options.seed);
  const auto material = Material::create(fitted);
  const Pattern left = pattern_of(*material, pairs, input.options.cosine);
  if (left.anisotropic() < std::max(kStrong, kSigmas * left.noise)) return std::nullopt;
  if (!has_tangents(input.form)) {
    return "the data look anisotropic, " +
           (left.of_one_azimuth() ? "with turned axes" : turned_by(left.degrees())) +
           ": a model with tangents may fit better";
  }
  const auto better = explained(input, spec);
  if (!better || !(better->l1 < kBetter * report.errors.all.l1)) return std::nullopt;
  return "the data look anisotropic, " + turned_by(better->rotation) + ": an anisotropic fit" +
         (input.options.anisotropic ? " that finds its rotation" : "") + " comes to an L1 of " +
         text(better->l1, "%.2g") + " in place of " + text(report.errors.all.l1, "%.2g");
}

}  // namespace

void add_hint(const SearchInput& input, const MaterialSpec& spec, const MaterialSpec& fitted,
              Certificate& report) {
  const auto found = hint(input, spec, fitted, report);
  if (found) report.reason += "; " + *found;
}

}  // namespace gonio::fit
