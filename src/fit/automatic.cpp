// The default strategy. The stages as published find the best optimum from one start in five;
// a scan of the few shape parameters with all colours solved exactly, then descents from its most
// distinct nodes, found it in all of 2,400.
//
// The caller's guess is one more start. It cannot harm: what the others lead to does not depend on
// it, and it is taken only where its own end is better. Nor is it ignored: its descent goes on with
// more pairs like the best of the others, unless it came to where one of them is.
#include <algorithm>
#include <array>

#include "fit/rotation.h"
#include "fit/scan.h"
#include "fit/search.h"

namespace gonio::fit {
namespace {

constexpr std::array kCoarse{0.1, 0.01};
constexpr std::array kFine{0.01, 0.001};
constexpr double kAgree = 1.01;
constexpr std::size_t kFinalists = 2;  // beside the guess
// A descent that ends so much above the best on the scan's pairs is not the best on more pairs.
constexpr double kHopeless = 1.03;
// Nor does the last stage of smoothing make up for this.
constexpr double kBehind = 1.005;
constexpr int kScanPasses = 3;

struct Candidate {
  std::vector<double> parameters;
  double objective;
  bool given;  // from the caller's guess?
};

// Descends on the scan's pairs from the nodes, the models' own start and the guess.
std::vector<Candidate> descend(const SearchInput& input, const Form& form, Problem& problem,
                               std::vector<Node> nodes, Search& search) {
  const double begin = cpu_seconds();
  nodes.push_back(solve_node(problem, start_of(form), kScanPasses));
  const std::size_t own = nodes.size();
  if (has_guess(form)) nodes.push_back(solve_node(problem, guess_of(form), kScanPasses));
  std::vector<Candidate> ends;
  double best = 1e300;
  int iterations = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    MinimiseOptions options = minimise_options(input.watch, "starts", 30, best);
    options.tolerance = 2e-4;
    const Minimum end = minimise_by_stages(problem, nodes[i].parameters, kCoarse, options);
    const double objective = problem.cost(end.parameters, true, input.watch.stop);
    iterations += end.iterations;
    search.starts.push_back({i >= own, natural(form, nodes[i].parameters),
                             natural(form, end.parameters), objective, false});
    ends.push_back({end.parameters, objective, search.starts.back().given});
  }
  const auto least = std::min_element(
      ends.begin(), ends.end(),
      [](const Candidate& a, const Candidate& b) { return a.objective < b.objective; });
  for (Start& start : search.starts) start.agrees = start.objective <= kAgree * least->objective;
  search.stages.push_back(
      {"starts", least->objective, problem.data().size(), iterations, cpu_seconds() - begin});
  std::stable_sort(ends.begin(), ends.end(), [](const Candidate& a, const Candidate& b) {
    return a.objective < b.objective;
  });
  return ends;
}

// Are the shapes of two ends the same, within a twentieth of what a scan covers? Descents on the
// scan's pairs are not run to their very end.
bool same(const Form& form, const Candidate& a, const Candidate& other) {
  const std::vector<double> b = near_turn(form, a.parameters, other.parameters);
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    const ShapeParameter& shape = form.shapes[i];
    const double range =
        shape.scale.to_search(shape.scan_upper) - shape.scale.to_search(shape.scan_lower);
    if (std::abs(a.parameters[i] - b[i]) > 0.05 * range) return false;
  }
  return true;
}

// The best distinct ends of all others and, last, the guess's if it is another.
std::vector<Candidate> finalists(const Form& form, const std::vector<Candidate>& sorted) {
  std::vector<Candidate> chosen;
  const auto choose = [&](bool given, std::size_t most) {
    for (const Candidate& end : sorted) {
      if (end.given != given || chosen.size() >= most) continue;
      if (!chosen.empty() && end.objective > kHopeless * chosen.front().objective) continue;
      const bool known = std::any_of(chosen.begin(), chosen.end(),
                                     [&](const Candidate& c) { return same(form, c, end); });
      if (!known) chosen.push_back(end);
    }
  };
  choose(false, kFinalists);
  choose(true, kFinalists + 1);
  return chosen;
}

// One after the other on more pairs, each to its end unless it stays behind those before.
void refine(const SearchInput& input, const std::vector<Candidate>& from, Search& search) {
  const double begin = cpu_seconds();
  const Data pairs = subset(input.data, input.options.fit_pairs, input.options.seed);
  Problem problem(input.form, pairs, input.loss, input.options.cosine);
  double best = 1e300, shown = 1e300;
  int iterations = 0;
  for (const Candidate& candidate : from) {
    MinimiseOptions options = minimise_options(input.watch, "fit", 25, shown);
    options.tolerance = 1e-5;
    Minimum end{candidate.parameters, 0, 0, true};
    double objective = 1e300;
    for (const double part : kFine) {
      end = minimise_by_stages(problem, end.parameters, {&part, 1}, options);
      objective = problem.cost(end.parameters, true, input.watch.stop);
      iterations += end.iterations;
      if (objective > kBehind * best || !problem.loss().absolute()) break;
    }
    if (!(objective < best)) continue;
    best = objective;
    search.parameters = std::move(end.parameters);
    search.converged = end.converged;
  }
  search.stages.push_back({"fit", best, pairs.size(), iterations, cpu_seconds() - begin});
}

}  // namespace

Search search_automatic(const SearchInput& input) {
  Search search;
  const double begin = cpu_seconds();
  // Another seed than the fit's: a sample that misleads does so once.
  const Data pairs = subset(input.data, input.options.scan_pairs, input.options.seed + 1);
  Problem problem(input.form, pairs, input.loss, input.options.cosine);
  const Scan nodes = scan(problem, input.options.starts, input.watch);
  if (nodes.stopped || nodes.best.empty()) return search;
  search.stages.push_back({"scan", nodes.best.front().cost, pairs.size(),
                           static_cast<int>(nodes.nodes), cpu_seconds() - begin});
  const auto ends = descend(input, input.form, problem, nodes.best, search);
  refine(input, finalists(input.form, ends), search);
  return input.options.polish ? polish(input, std::move(search)) : search;
}

}  // namespace gonio::fit
