#include "fit/search/same_place.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "fit/search/rotation.h"

namespace gonio::fit {
namespace {

bool is_far(const ShapeParameter& shape, double a, double b) {
  const auto place = [&](double p) { return shape.scale.to_search(std::max(p, shape.lower)); };
  const double range = place(shape.scan_upper) - place(shape.scan_lower);
  return std::abs(place(a) - place(b)) > 0.1 * range;
}

bool are_alike(const FormLobe& a, const FormLobe& b) {
  return a.model == b.model && a.held.parameters == b.held.parameters;
}

// A lobe's own shapes: the rotation belongs to all lobes with tangents.
std::vector<std::size_t> shapes_of(const Form& form, std::size_t lobe) {
  std::vector<std::size_t> shapes;
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    if (form.shapes[i].lobe == lobe && form.rotation_shape != i) shapes.push_back(i);
  }
  return shapes;
}

// Lobe i of `a` against lobe order[i] of `b`; they are alike.
std::vector<Apart> differences(const Form& form, std::span<const double> a,
                               std::span<const double> b, const std::vector<std::size_t>& order) {
  std::vector<Apart> found;
  for (std::size_t lobe = 0; lobe < order.size(); ++lobe) {
    const auto own = shapes_of(form, lobe), other = shapes_of(form, order[lobe]);
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (is_far(form.shapes[own[k]], a[own[k]], b[other[k]]))
        found.push_back({own[k], a[own[k]], b[other[k]]});
    }
  }
  if (const auto r = form.rotation_shape; r && is_far(form.shapes[*r], a[*r], b[*r]))
    found.push_back({*r, a[*r], b[*r]});
  return found;
}

}  // namespace

std::optional<Apart> apart(const Form& form, std::span<const double> a, std::span<const double> b) {
  const std::vector<double> turned_alike = near_turn(form, a, b);
  b = turned_alike;
  const auto& lobes = form.lobes;  // a base and up to four others
  std::vector<std::size_t> order(lobes.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<Apart> fewest = differences(form, a, b, order);
  while (!fewest.empty() && std::next_permutation(order.begin(), order.end())) {
    bool alike = true;
    for (std::size_t i = 0; i < order.size(); ++i)
      alike = alike && are_alike(lobes[i], lobes[order[i]]);
    if (!alike) continue;
    auto found = differences(form, a, b, order);
    if (found.size() < fewest.size()) fewest = std::move(found);
  }
  if (fewest.empty()) return {};
  return fewest.front();
}

}  // namespace gonio::fit
