// The strategies by which a fit looks for its optimum.
#pragma once

#include "fit/fit.h"
#include "fit/search/minimise.h"
#include "fit/search/problem.h"

namespace gonio::fit {

double cpu_seconds();  // of the calling thread

// What both strategies work with.
struct SearchInput {
  const Form& form;
  const Data& data;  // the pairs to fit
  const Options& options;
  const Watch& watch;
  Loss loss;
};

struct Search {
  std::vector<double> parameters;
  std::vector<Stage> stages;
  std::vector<Start> starts;
  bool converged = true;
};

Search search_automatic(const SearchInput& input);
Search search_staged(const SearchInput& input);

// Helpers of both.
std::vector<double> start_of(const Form& form);  // the models' own shapes, in search scale
bool has_guess(const Form& form);
std::vector<double> guess_of(const Form& form);  // the caller's, completed by the models' own
std::vector<double> natural(const Form& form, std::span<const double> parameters);
MinimiseOptions minimise_options(const Watch& watch, std::string_view stage, int iterations,
                                 double& best);
Search polish(const SearchInput& input, Search search);

}  // namespace gonio::fit
