// What repetitions of a measurement say.
//
// The best one counts: a machine may be busy, but it is seldom busy throughout, and nothing makes
// work faster than it is. The quartiles say how far that can be trusted. Thread safety: plain
// values, a function without state.
#pragma once

#include <span>

namespace gonio::timing {

struct Spread {
  double best = 0;                          // the least; what is compared
  double lower = 0, median = 0, upper = 0;  // quartiles
  int repetitions = 0;
};

// Of any times, in their unit; zeros for none.
Spread spread_of(std::span<const double> times);

// The same in another unit.
Spread scaled(const Spread& spread, double factor);

}  // namespace gonio::timing
