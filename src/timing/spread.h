// Best and quartiles of repeated measurements.
//
// The best one counts: other work on a machine comes and goes, and only ever adds time. The
// quartiles show how much the times vary. Thread safety: plain values, a function without state.
#pragma once

#include <span>

namespace gonio::timing {

struct Spread {
  double best = 0;                          // the least; what is compared
  double lower = 0, median = 0, upper = 0;  // quartiles
  int repetitions = 0;
};

// The spread of any times, in their unit; zeros where there are none.
Spread spread_of(std::span<const double> times);

// The same in another unit.
Spread scaled(const Spread& spread, double factor);

}  // namespace gonio::timing
