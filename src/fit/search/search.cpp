#include "fit/search/search.h"

#include <algorithm>
#include <ctime>

namespace gonio::fit {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<double> start_of(const Form& form) {
  std::vector<double> start;
  for (const ShapeParameter& shape : form.shapes)
    start.push_back(shape.scale.to_search(shape.start));
  return start;
}

bool has_guess(const Form& form) {
  return std::any_of(form.shapes.begin(), form.shapes.end(),
                     [](const ShapeParameter& shape) { return shape.guess.has_value(); });
}

std::vector<double> guess_of(const Form& form) {
  std::vector<double> guess;
  for (const ShapeParameter& shape : form.shapes)
    guess.push_back(shape.scale.to_search(shape.guess.value_or(shape.start)));
  return guess;
}

std::vector<double> natural(const Form& form, std::span<const double> parameters) {
  std::vector<double> result;
  for (std::size_t i = 0; i < form.shapes.size(); ++i)
    result.push_back(form.shapes[i].scale.to_parameter(parameters[i]));
  return result;
}

MinimiseOptions minimise_options(const Watch& watch, std::string_view stage, int iterations,
                                 double& best) {
  MinimiseOptions options;
  options.iterations = iterations;
  options.stop = watch.stop;
  if (watch.progress) {
    options.progress = [&watch, stage, &best](int iteration, double cost) {
      best = std::min(best, cost);
      watch.progress({std::string(stage), iteration, cost, best});
    };
  }
  return options;
}

Search polish(const SearchInput& input, Search search) {
  const double begin = cpu_seconds();
  Problem problem(input.form, input.data, input.loss, input.options.cosine);
  double best = 1e300;
  MinimiseOptions options = minimise_options(input.watch, "polish", 10, best);
  options.tolerance = 1e-5;
  constexpr std::array kParts{0.01};
  const double before = problem.cost(search.parameters, true, input.watch.stop);
  Minimum end = minimise_by_stages(problem, search.parameters, kParts, options);
  const double after = problem.cost(end.parameters, true, input.watch.stop);
  if (after < before) search.parameters = std::move(end.parameters);
  search.stages.push_back({"polish", std::min(before, after), input.data.size(), end.iterations,
                           cpu_seconds() - begin});
  return search;
}

}  // namespace gonio::fit
