// The strategy that Nielsen, Frisvad, Conradsen & Aanaes 2014 print: (i) the diffuse colour and the
// lobe's height; (ii) its shape; (iii) shape and height. It starts from one guess and stays near
// it: where the first stage gives a lobe of the wrong width no height, the second has no gradient.
#include <array>

#include "fit/linear/solved_colours.h"
#include "fit/search/search.h"

namespace gonio::fit {
namespace {

constexpr std::array kSmooth{0.1, 0.01, 0.001};
constexpr int kPasses = 8;

// Which parameters move: shapes, specular coefficients, diffuse ones.
std::vector<bool> moving(const Form& form, int channels, bool shapes, bool specular, bool diffuse) {
  std::vector<bool> free(form.shapes.size(), shapes);
  for (int c = 0; c < channels; ++c) {
    for (const FormLobe& lobe : form.lobes) {
      const bool base = is_diffuse(lobe.colours.columns);
      free.insert(free.end(), lobe.coefficient_count, base ? diffuse : specular);
    }
  }
  return free;
}

}  // namespace

Search search_staged(const SearchInput& input) {
  Search search;
  const Form& form = input.form;
  const Data pairs = subset(input.data, input.options.fit_pairs, input.options.seed);
  Problem problem(form, pairs, input.loss, input.options.cosine);
  double begin = cpu_seconds(), best = 1e300;
  const auto guess = guess_of(form);
  SolvedColours colours = solve_colours(problem, guess, kPasses);
  search.parameters = colours.parameters;
  search.stages.push_back({"colours", colours.cost, pairs.size(), kPasses, cpu_seconds() - begin});
  const int channels = pairs.channels;
  const auto run = [&](const char* name, std::vector<bool> free) {
    begin = cpu_seconds();
    MinimiseOptions options = minimise_options(input.watch, name, 50, best);
    options.free = std::move(free);
    Minimum end = minimise_by_stages(problem, search.parameters, kSmooth, options);
    const double objective = problem.cost(end.parameters, true, input.watch.stop);
    search.stages.push_back({name, objective, pairs.size(), end.iterations, cpu_seconds() - begin});
    search.parameters = std::move(end.parameters);
    search.converged = end.converged;
  };
  run("shapes", moving(form, channels, true, false, false));
  run("shapes and lobes", moving(form, channels, true, true, false));
  search.starts = {{has_guess(form), natural(form, guess), natural(form, search.parameters),
                    search.stages.back().objective, true}};
  return input.options.polish ? polish(input, std::move(search)) : search;
}

}  // namespace gonio::fit
