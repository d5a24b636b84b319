#include "fit/linear/objective.h"

#include <cmath>

namespace gonio::fit {

double Loss::transformed(double value) const {
  if (objective == Objective::log) return std::log1p(value);
  if (objective == Objective::cbrt) return std::cbrt(value);
  return value;
}

double Loss::loss(double e) const {
  const double size = std::abs(e);
  if (absolute()) return smooth > 0 ? std::sqrt(e * e + smooth * smooth) : size;
  if (objective == Objective::huber && size > threshold)
    return threshold * (size - 0.5 * threshold);
  return 0.5 * e * e;
}

double Loss::weight(double e) const {
  if (absolute()) return 1 / std::sqrt(e * e + smooth * smooth);
  if (objective == Objective::huber && std::abs(e) > threshold) return threshold / std::abs(e);
  return 1;
}

}  // namespace gonio::fit
