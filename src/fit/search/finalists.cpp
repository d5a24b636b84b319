#include "fit/search/finalists.h"

#include <algorithm>
#include <cmath>

#include "fit/search/rotation.h"

namespace gonio::fit {
namespace {

constexpr std::size_t kFinalists = 2;  // beside the guess
// An end whose objective on the scan's pairs is above this times the best one's is not the best on
// more pairs: with this bound tests/fit/published_test.cpp still finds every published optimum.
constexpr double kWorthFollowing = 1.03;

// Are the shapes of two ends the same, within a twentieth of what a scan covers? Descents on the
// scan's pairs are not run to their very end.
bool same(const Form& form, const DescentEnd& a, const DescentEnd& other) {
  const std::vector<double> b = near_turn(form, a.parameters, other.parameters);
  for (std::size_t i = 0; i < form.shapes.size(); ++i) {
    const ShapeParameter& shape = form.shapes[i];
    const double range =
        shape.scale.to_search(shape.scan_upper) - shape.scale.to_search(shape.scan_lower);
    if (std::abs(a.parameters[i] - b[i]) > 0.05 * range) return false;
  }
  return true;
}

}  // namespace

std::vector<DescentEnd> finalists(const Form& form, const std::vector<DescentEnd>& sorted) {
  std::vector<DescentEnd> chosen;
  const auto choose = [&](bool given, std::size_t most) {
    for (const DescentEnd& end : sorted) {
      if (end.given != given || chosen.size() >= most) continue;
      if (!chosen.empty() && end.objective > kWorthFollowing * chosen.front().objective) continue;
      const bool known = std::any_of(chosen.begin(), chosen.end(),
                                     [&](const DescentEnd& c) { return same(form, c, end); });
      if (!known) chosen.push_back(end);
    }
  };
  choose(false, kFinalists);
  choose(true, kFinalists + 1);
  return chosen;
}

}  // namespace gonio::fit
