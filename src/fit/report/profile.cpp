#include "fit/report/profile.h"

#include <algorithm>
#include <array>

#include "fit/linear/solved_colours.h"
#include "fit/search/scan.h"

namespace gonio::fit {
namespace {

constexpr double kAsGood = 1.01;
constexpr int kPasses = 4, kIterations = 8;
constexpr std::array kSmooth{0.05};

struct Point {
  double value, objective;  // in search scale
};

// The best objective with one shape held; the others start where they are best.
double held_at(Problem& problem, std::span<const double> best, std::size_t shape, double value,
               const Stop& stop) {
  std::vector<double> start(best.begin(), best.end());
  start[shape] = value;
  const auto shapes = std::span<const double>(start).first(problem.form().shapes.size());
  const SolvedColours begin = solve_colours(problem, shapes, kPasses);
  MinimiseOptions options;
  options.iterations = kIterations;
  options.tolerance = 1e-3;
  options.stop = stop;
  options.free.assign(start.size(), true);
  options.free[shape] = false;
  const Minimum end = minimise_by_stages(problem, begin.parameters, kSmooth, options);
  return std::min(begin.cost, problem.cost(end.parameters, true, stop));
}

Profile summarise(const ShapeParameter& shape, std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.value < b.value; });
  const auto best =
      std::min_element(points.begin(), points.end(),
                       [](const Point& a, const Point& b) { return a.objective < b.objective; });
  const auto good = [&](const Point& p) { return p.objective <= kAsGood * best->objective; };
  const auto first = std::find_if(points.begin(), points.end(), good);
  const auto last = std::find_if(points.rbegin(), points.rend(), good).base() - 1;
  Profile profile;
  profile.field = shape.field;
  profile.lower = shape.scale.to_parameter(first->value);
  profile.upper = shape.scale.to_parameter(last->value);
  profile.part = (last->value - first->value) / (shape.scale.to_search(shape.scan_upper) -
                                                 shape.scale.to_search(shape.scan_lower));
  profile.separate = !std::all_of(first, last + 1, good);
  return profile;
}

}  // namespace

std::vector<Profile> profiles_of(const SearchInput& input, std::span<const double> parameters) {
  const Data pairs = subset(input.data, input.options.scan_pairs, input.options.seed + 1);
  Problem problem(input.form, pairs, input.loss, input.options.cosine);
  const auto axes = scan_axes(input.form);
  std::vector<Profile> profiles;
  for (std::size_t i = 0; i < input.form.shapes.size(); ++i) {
    const ShapeParameter& shape = input.form.shapes[i];
    if (is_width(shape)) continue;
    std::vector<Point> points;
    std::vector<double> values = axes[i];
    values.push_back(parameters[i]);
    for (const double value : values) {
      if (input.watch.stop && input.watch.stop()) return profiles;
      points.push_back({value, held_at(problem, parameters, i, value, input.watch.stop)});
    }
    profiles.push_back(summarise(shape, std::move(points)));
  }
  return profiles;
}

}  // namespace gonio::fit
