// The default strategy. The stages as published find the best optimum from one start in five;
// a scan of the few shape parameters with all colours solved exactly, then descents from its most
// distinct nodes, found it in all of 2,400.
//
// The caller's guess is one more start. It cannot harm: what the others lead to does not depend on
// it, and it is taken only where its own end is better. Nor is it ignored: its descent goes on with
// more pairs like the best of the others, unless it came to where one of them is.
//
// Where the best of all ends at a bound of a shape, or between that bound and where the scan
// looked, the scan knew little of the others there: with that shape held at the bound they are
// scanned anew, more finely, and the best nodes are starts, too.
#include <algorithm>
#include <array>

#include "fit/search/finalists.h"
#include "fit/search/scan.h"
#include "fit/search/search.h"

namespace gonio::fit {
namespace {

constexpr std::array kCoarse{0.1, 0.01};
constexpr std::array kFine{0.01, 0.001};
constexpr double kAgree = 1.01;
constexpr std::size_t kHeldStarts = 2;  // with a shape held at its bound, beside the models' own
// A finalist whose objective is above this times that of those before it is not taken through the
// last stage of smoothing, which lowers an objective by less.
constexpr double kTooFarBehind = 1.005;
constexpr int kScanPasses = 3;

bool ends_lower(const DescentEnd& a, const DescentEnd& b) { return a.objective < b.objective; }

// Descents on the scan's pairs.
class Descents {
 public:
  Descents(const SearchInput& input, Problem& problem, Search& search)
      : input_(input), problem_(problem), search_(search) {}

  void from(std::span<const double> shapes, bool given) {
    from(solve_colours(problem_, shapes, kScanPasses), given);
  }
  void from(const SolvedColours& node, bool given) {
    MinimiseOptions options = minimise_options(input_.watch, "starts", 30, best_);
    options.tolerance = 2e-4;
    const Minimum end = minimise_by_stages(problem_, node.parameters, kCoarse, options);
    const double objective = problem_.cost(end.parameters, true, input_.watch.stop);
    iterations_ += end.iterations;
    search_.starts.push_back({given, natural(input_.form, node.parameters),
                              natural(input_.form, end.parameters), objective, false});
    ends_.push_back({end.parameters, objective, given});
  }
  [[nodiscard]] std::vector<double> least() const {
    return std::min_element(ends_.begin(), ends_.end(), ends_lower)->parameters;
  }
  // The ends, the best first.
  std::vector<DescentEnd> finish() {
    std::stable_sort(ends_.begin(), ends_.end(), ends_lower);
    const double least = ends_.front().objective;
    for (Start& start : search_.starts) start.agrees = start.objective <= kAgree * least;
    search_.stages.push_back(
        {"starts", least, problem_.data().size(), iterations_, cpu_seconds() - begin_});
    return std::move(ends_);
  }

 private:
  const SearchInput& input_;
  Problem& problem_;
  Search& search_;
  const double begin_ = cpu_seconds();
  double best_ = 1e300;  // as smoothed
  int iterations_ = 0;
  std::vector<DescentEnd> ends_;
};

// The shapes that end at a bound, or between it and where a scan looks, each held at that bound.
std::vector<Held> held_shapes(const Form& form, std::span<const double> end) {
  constexpr double kAtBound = 1e-9;  // what descents leave, in search scale
  std::vector<Held> held;
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    if (form.rotation_shape == i) continue;  // it goes round
    const ShapeParameter& shape = form.shapes[i];
    if (end[i] <= shape.scale.to_search(shape.scan_lower) + kAtBound)
      held.push_back({i, shape.scale.to_search(shape.lower)});
    else if (end[i] >= shape.scale.to_search(shape.scan_upper) - kAtBound)
      held.push_back({i, shape.scale.to_search(shape.upper)});
  }
  return held;
}

bool same_bound(const Held& a, const Held& b) { return a.shape == b.shape && a.at == b.at; }

// With each shape held, one after the other, that the best of all took to a bound: from what a scan
// of the others finds, and from the models' own start. Where that leads to new bounds, again.
void descend_held(const SearchInput& input, const Problem& problem, Descents& descents) {
  const Form& form = input.form;
  if (form.shapes.size() < 2) return;       // a single one leaves nothing to scan
  const Watch quiet{{}, input.watch.stop};  // the stage "scan" is over
  std::vector<Held> known;
  for (bool more = true; more;) {
    more = false;
    for (const Held& held : held_shapes(form, descents.least())) {
      if (std::any_of(known.begin(), known.end(),
                      [&](const Held& other) { return same_bound(held, other); }))
        continue;
      known.push_back(held);
      more = true;
      for (const SolvedColours& node : scan(problem, kHeldStarts, quiet, held).best)
        descents.from(node, false);
      std::vector<double> start = start_of(form);
      start[held.shape] = held.at;
      descents.from(start, false);
    }
  }
}

// The guess comes last: it has no say in where the others start.
std::vector<DescentEnd> descend(const SearchInput& input, const std::vector<SolvedColours>& nodes,
                                Problem& problem, Search& search) {
  Descents descents(input, problem, search);
  for (const SolvedColours& node : nodes) descents.from(node, false);
  descents.from(start_of(input.form), false);
  descend_held(input, problem, descents);
  if (has_guess(input.form)) descents.from(guess_of(input.form), true);
  return descents.finish();
}

// One after the other on more pairs, each to its end unless it stays behind those before.
void refine(const SearchInput& input, const std::vector<DescentEnd>& from, Search& search) {
  const double begin = cpu_seconds();
  const Data pairs = subset(input.data, input.options.fit_pairs, input.options.seed);
  Problem problem(input.form, pairs, input.loss, input.options.cosine);
  double best = 1e300, shown = 1e300;
  int iterations = 0;
  for (const DescentEnd& finalist : from) {
    MinimiseOptions options = minimise_options(input.watch, "fit", 25, shown);
    options.tolerance = 1e-5;
    Minimum end{finalist.parameters, 0, 0, true};
    double objective = 1e300;
    for (const double part : kFine) {
      end = minimise_by_stages(problem, end.parameters, {&part, 1}, options);
      objective = problem.cost(end.parameters, true, input.watch.stop);
      iterations += end.iterations;
      if (objective > kTooFarBehind * best || !problem.loss().absolute()) break;
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
  const auto ends = descend(input, nodes.best, problem, search);
  refine(input, finalists(input.form, ends), search);
  return input.options.polish ? polish(input, std::move(search)) : search;
}

}  // namespace gonio::fit
