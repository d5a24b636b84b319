#include "fit/report/certify.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "fit/report/albedo.h"
#include "fit/report/metrics.h"
#include "fit/report/profile.h"
#include "fit/report/uncertainty.h"
#include "fit/report/verdict.h"

namespace gonio::fit {
namespace {

constexpr std::array kAlbedoDegrees{0.0, 30.0, 60.0, 80.0};

void add_uncertainty(const SearchInput& input, std::span<const double> parameters,
                     Certificate& report) {
  const Data pairs = subset(input.data, input.options.fit_pairs, input.options.seed);
  Problem problem(input.form, pairs, input.loss, input.options.cosine);
  problem.set_smooth(smooth_of(problem, parameters, input.watch.stop));
  const std::size_t found_on = report.stages.empty() ? 0 : report.stages.back().pairs;
  Uncertainty found = uncertainty_at(problem, parameters, found_on, input.watch.stop);
  report.gradient_norm = found.gradient_norm;
  report.parameters = std::move(found.parameters);
  report.indistinct = std::move(found.indistinct);
  report.active_bounds = std::move(found.active_bounds);
}

void add_errors(const Material& material, const Data& data, Certificate& report) {
  Comparison comparison = compare(material, data);
  report.errors = comparison.errors;
  report.regions = comparison.regions;
  report.worst = std::move(comparison.worst);
  for (const double degrees : kAlbedoDegrees) {
    const double theta = degrees * std::numbers::pi / 180;
    report.albedo.push_back({theta, directional_albedo(material, theta)});
  }
}

Certificate begun(const Data& data, const Options& options) {
  Certificate report;
  report.objective = options.objective;
  report.pairs = data.size();
  report.left_out = data.left_out;
  return report;
}

}  // namespace

FitResult certify(const SearchInput& input, const Data& data, Search search) {
  FitResult result{{}, begun(data, input.options)};
  Certificate& report = result.certificate;
  for (const ShapeParameter& shape : input.form.shapes) report.shapes.push_back(shape.field);
  report.stages = std::move(search.stages);
  report.starts = std::move(search.starts);
  report.agreeing = static_cast<std::size_t>(std::count_if(
      report.starts.begin(), report.starts.end(), [](const Start& s) { return s.agrees; }));
  result.material = to_material(input.form, search.parameters, data.channels);
  const auto material = Material::create(result.material);
  assert(material.ok());  // its numbers are clamped to the tables' bounds
  add_uncertainty(input, search.parameters, report);
  report.profiles = profiles_of(input, search.parameters);
  add_errors(*material, data, report);
  set_verdict(input.form, search.parameters, input.data, report);
  return result;
}

FitResult nothing_to_fit(const Data& data, const Options& options) {
  FitResult result{{}, begun(data, options)};
  result.certificate.reason = "no pair is left to fit: " + std::to_string(data.left_out.total()) +
                              " were left out, and " + std::to_string(data.size()) +
                              " are outside the angles";
  return result;
}

}  // namespace gonio::fit
