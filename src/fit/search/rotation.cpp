#include "fit/search/rotation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/data/pattern.h"
#include "fit/report/uncertainty.h"

namespace gonio::fit {
namespace {

constexpr double kQuarter = 90;  // degrees
// A pattern that chance makes in one of 400 fits starts a second search, which costs time alone.
constexpr double kTrigger = 3;
// A turned fit is taken only if its objective is below this part of the aligned one's: objectives
// are known to about 0.1 %.
constexpr double kGain = 0.999;

// The shape of a lobe's parameter by itself; none if it is held equal to another, or is no shape.
std::optional<std::size_t> shape_named(const Form& form, std::size_t lobe, std::string_view name) {
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    const ShapeParameter& shape = form.shapes[i];
    if (shape.lobe == lobe && shape.names.size() == 1 && shape.names.front() == name) return i;
  }
  return std::nullopt;
}

// Swaps what belongs to u and v in every lobe.
void swap_tangents(const Form& form, std::vector<double>& shapes) {
  for (std::size_t lobe = 0; lobe < form.lobes.size(); ++lobe) {
    const ModelDescription& model = *form.lobes[lobe].model;
    if (!model.has_tangents()) continue;
    const auto u = shape_named(form, lobe, model.along_tangents[0]),
               v = shape_named(form, lobe, model.along_tangents[1]);
    if (u && v) std::swap(shapes[*u], shapes[*v]);
  }
}

std::vector<double> turned_near(const Form& form, double degrees, std::span<const double> shapes) {
  std::vector<double> result(shapes.begin(), shapes.end());
  if (!form.rotation_shape) return result;
  double& rotation = result[*form.rotation_shape];
  const double quarters = std::nearbyint((rotation - degrees) / kQuarter);
  rotation -= quarters * kQuarter;
  if (std::fmod(std::abs(quarters), 2) == 1) swap_tangents(form, result);
  return result;
}

Data pairs_of(const SearchInput& input) {
  return subset(input.data, input.options.fit_pairs, input.options.seed);
}

// The parameters of the aligned form as those of the turned one: the rotation is the last shape.
std::vector<double> with_rotation(const Form& turned, std::span<const double> aligned) {
  std::vector<double> parameters(aligned.begin(), aligned.end());
  parameters.insert(parameters.begin() + static_cast<std::ptrdiff_t>(*turned.rotation_shape), 0.0);
  return parameters;
}

}  // namespace

std::vector<double> near_turn(const Form& form, std::span<const double> like,
                              std::span<const double> shapes) {
  return turned_near(form, form.rotation_shape ? like[*form.rotation_shape] : 0, shapes);
}

Form with_shapes(const Form& form, const Form& of) {
  Form result = form;
  result.shapes = of.shapes;
  result.rotation = of.rotation;
  result.rotation_shape = of.rotation_shape;
  return result;
}

std::optional<Search> search_turned(const SearchInput& aligned, const SearchInput& turned,
                                    const Search& found) {
  if (found.parameters.empty()) return std::nullopt;
  const Stop& stop = aligned.watch.stop;
  const Data pairs = pairs_of(aligned);
  const Problem before(aligned.form, pairs, aligned.loss, aligned.options.cosine);
  const Pattern left = pattern_of(before, found.parameters, stop);
  if (!(std::abs(left.along_sin) > kTrigger * left.noise)) return std::nullopt;
  Search search = search_automatic(turned);
  if (search.parameters.empty()) return std::nullopt;
  const Problem after(turned.form, pairs, turned.loss, turned.options.cosine);
  const double least = kGain * before.cost(found.parameters, true, stop);
  if (!(after.cost(search.parameters, true, stop) < least)) return std::nullopt;
  search.parameters = turned_near(turned.form, 0, search.parameters);
  for (Stage& stage : search.stages) stage.name += ", turned";
  search.stages.insert(search.stages.begin(), found.stages.begin(), found.stages.end());
  return search;
}

void add_aligned(const SearchInput& turned, std::span<const double> aligned, Certificate& report) {
  const Data pairs = pairs_of(turned);
  Problem problem(turned.form, pairs, turned.loss, turned.options.cosine);
  const std::vector<double> parameters = with_rotation(turned.form, aligned);
  // Half-vectors of one azimuth, as tables of isotropic materials have them, cannot tell.
  constexpr double kOneAzimuth = 1e-3;
  if (pattern_of(problem, parameters, turned.watch.stop).half_spread < kOneAzimuth) return;
  problem.set_smooth(smooth_of(problem, parameters, turned.watch.stop));
  const std::size_t found_on = report.stages.empty() ? 0 : report.stages.back().pairs;
  const Uncertainty found = uncertainty_at(problem, parameters, found_on, turned.watch.stop);
  for (const ParameterReport& parameter : found.parameters) {
    if (parameter.field != kRotation.name || parameter.undetermined) continue;
    if (parameter.standard_error < kVagueDegrees) report.parameters.push_back(parameter);
  }
}

}  // namespace gonio::fit
