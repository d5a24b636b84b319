#include "fit/certify.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gonio::fit {

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 4> kNames{"converged", "bound-limited", "ambiguous",
                                                   "failed"};
  return kNames[static_cast<std::size_t>(verdict)];
}

FitResult certify(const SearchInput& input, const Data& data, Search search) {
  FitResult result;
  Certificate& report = result.certificate;
  report.objective = input.options.objective;
  report.pairs = data.size();
  report.left_out = data.left_out;
  for (const ShapeParameter& shape : input.form.shapes) report.shapes.push_back(shape.field);
  report.stages = std::move(search.stages);
  report.starts = std::move(search.starts);
  report.agreeing = static_cast<std::size_t>(std::count_if(
      report.starts.begin(), report.starts.end(), [](const Start& s) { return s.agrees; }));
  result.material =
      to_material(input.form, search.parameters, data.channels, &report.active_bounds);
  const auto material = Material::create(result.material);
  assert(material.ok());
  Comparison comparison = compare(*material, data);
  report.errors = comparison.errors;
  report.worst = std::move(comparison.worst);
  report.verdict = Verdict::converged;
  return result;
}

FitResult nothing_to_fit(const Data& data, const Options& options) {
  FitResult result;
  Certificate& report = result.certificate;
  report.objective = options.objective;
  report.left_out = data.left_out;
  report.pairs = data.size();
  report.reason = "no pair is left to fit: " + std::to_string(data.left_out.total()) +
                  " were left out, the others are outside the angles";
  return result;
}

}  // namespace gonio::fit
