// Whether two descents ended at the same material. Thread safety: functions without state.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "fit/form.h"

namespace gonio::fit {

// A shape parameter of the form by which two ends are apart, and what it is at each.
struct Apart {
  std::size_t shape;
  double at, other;
};

// Of `b` against `a`, both the form's shapes: the first that differs by more than a tenth of the
// range that is scanned; none if they are the same place. Lobes of one kind that have changed
// places are the same material: they are taken in the order that makes the fewest differences.
std::optional<Apart> apart(const Form& form, std::span<const double> a, std::span<const double> b);

}  // namespace gonio::fit
