#include "fit/search/scan.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gonio::fit {
namespace {

constexpr int kPasses = 3;
constexpr std::size_t kFinest = 28;  // nodes along a lobe's width: a factor of about 2 in s
constexpr std::size_t kMostNodes = 500;
constexpr std::size_t kMostNodesHeld = 130;  // beside a held shape: 5 along each of three others
constexpr double kNone = 1e300;              // above every objective

// Nodes along each axis, fewer where there are many axes.
std::vector<std::size_t> axis_counts(const Form& form, const std::optional<Held>& held) {
  std::vector<std::size_t> counts;
  const std::size_t most = held ? kMostNodesHeld : kMostNodes;
  const std::size_t shapes = form.shapes.size() - (held ? 1 : 0);
  const std::size_t gentle = shapes > 3 ? 3 : shapes > 2 ? 5 : 7;
  for (const ShapeParameter& shape : form.shapes)
    counts.push_back(is_width(shape) ? kFinest : gentle);
  if (held) counts[held->shape] = 1;
  const auto total = [&] {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{1}, std::multiplies<>());
  };
  // The largest first, down to what still tells basins apart.
  while (total() > most) {
    const auto largest = std::max_element(counts.begin(), counts.end());
    if (*largest <= 3) break;
    --*largest;
  }
  return counts;
}

// Of node `index`: its place along each axis.
std::vector<std::size_t> places_of(std::size_t index,
                                   const std::vector<std::vector<double>>& axes) {
  std::vector<std::size_t> places(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    places[a] = index % axes[a].size();
    index /= axes[a].size();
  }
  return places;
}

// The distance of two nodes as parts of the axes' lengths, the largest.
double apart(std::size_t a, std::size_t b, const std::vector<std::vector<double>>& axes) {
  const auto at = places_of(a, axes), bt = places_of(b, axes);
  double most = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double steps = std::abs(static_cast<double>(at[i]) - static_cast<double>(bt[i]));
    most = std::max(most, steps / static_cast<double>(axes[i].size()));
  }
  return most;
}

// Good nodes that are far from each other: the best one, and then again and again the best that is
// at least so far from all taken.
std::vector<std::size_t> most_distinct(const std::vector<double>& costs, std::size_t keep,
                                       const std::vector<std::vector<double>>& axes) {
  constexpr double kApart = 0.1;
  std::vector<std::size_t> order(costs.size()), taken;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  for (const std::size_t node : order) {
    if (taken.size() == keep) break;
    const bool far = std::all_of(taken.begin(), taken.end(), [&](std::size_t other) {
      return apart(node, other, axes) > kApart;
    });
    if (far) taken.push_back(node);
  }
  return taken;
}

std::vector<double> shapes_of(std::size_t node, const std::vector<std::vector<double>>& axes) {
  const auto places = places_of(node, axes);
  std::vector<double> shapes;
  for (std::size_t a = 0; a < axes.size(); ++a) shapes.push_back(axes[a][places[a]]);
  return shapes;
}

}  // namespace

std::vector<std::vector<double>> scan_axes(const Form& form, std::optional<Held> held) {
  const auto counts = axis_counts(form, held);
  std::vector<std::vector<double>> axes;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const ShapeParameter& shape = form.shapes[i];
    const double lower = shape.scale.to_search(shape.scan_lower);
    const double upper = shape.scale.to_search(shape.scan_upper);
    auto& axis = axes.emplace_back();
    if (held && held->shape == i) {
      axis.push_back(held->at);
      continue;
    }
    for (std::size_t k = 0; k < counts[i]; ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(counts[i] - 1);
      axis.push_back(lower + part * (upper - lower));
    }
  }
  return axes;
}

Scan scan(const Problem& problem, std::size_t keep, const Watch& watch, std::optional<Held> held) {
  const auto axes = scan_axes(problem.form(), held);
  Scan result;
  result.nodes = 1;
  for (const auto& axis : axes) result.nodes *= axis.size();
  std::vector<double> costs;
  double best = kNone;
  for (std::size_t node = 0; node < result.nodes; ++node) {
    if (watch.stop && watch.stop()) return result.stopped = true, result;
    const double cost = solve_colours(problem, shapes_of(node, axes), kPasses).cost;
    costs.push_back(std::isfinite(cost) ? cost : kNone);
    best = std::min(best, costs.back());
    if (watch.progress) watch.progress({"scan", static_cast<int>(node), costs.back(), best});
  }
  for (const std::size_t node : most_distinct(costs, keep, axes))
    result.best.push_back(solve_colours(problem, shapes_of(node, axes), kPasses));
  return result;
}

}  // namespace gonio::fit
