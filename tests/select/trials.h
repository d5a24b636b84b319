// Selections on references whose generating model is known, by seed.
#pragma once

#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "select/select.h"

namespace gonio::testing {

using Random = std::mt19937_64;
double between(Random& random, double lower, double upper);  // evenly

// A kind of reference: what a selection should call it, and a material of random numbers.
struct Truth {
  std::string name;
  MaterialSpec (*draw)(Random& random);
};
inline void PrintTo(const Truth& truth, std::ostream* out) { *out << truth.name; }
const std::vector<Truth>& truths();

// Both angles up to so many degrees, at a tolerance of the relative L1 error.
select::Scene scene_to(double degrees, double tolerance);

// A fixed price for every part, so that trials do not depend on what the machine is doing: about
// what an AVX-512 core takes.
select::CostTable fixed_costs();

select::Options trial_options(std::uint64_t seed);

// Measured pairs of the truth up to 75 degrees with 2 % noise, at a tolerance a quarter above what
// the noise alone is.
struct Trial {
  select::Selection selection;
  std::string chosen;  // a candidate's name, or "nothing"
  // Does the choice have more free numbers than the generating model?
  bool larger = false;
};
Trial run_trial(const Truth& truth, std::uint64_t seed);

// Does a choice keep what it is certified for? A noiseless material is selected for at a tolerance;
// then again, by other pairs, at one that is within some percent of what the choice truly errs by,
// the hardest case there is. The error on 100,000 fresh pairs decides.
struct Check {
  bool chosen = false;  // was there a choice other than the reference itself?
  bool misses = false;  // is its error above the tolerance?
};
Check run_check(const Truth& truth, std::uint64_t seed);

// How often the 95 % bound of one material's error against another of its kind, from so many pairs,
// is below the error on 400,000.
struct Coverage {
  std::size_t draws = 0, misses = 0;
};
Coverage run_coverage(const Truth& truth, std::uint64_t seed, std::size_t draws, std::size_t pairs);

}  // namespace gonio::testing
