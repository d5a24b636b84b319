// Chooses the cheapest material that is good enough for what a scene looks at, and says why.
//
//   select::Scene scene;
//   scene.bins = {{.theta_i = {0, 1.3}, .theta_o = {0, 1.3}}};
//   scene.tolerance = 0.05;
//   auto result = select::choose(data, scene, {});   // result->choice->material
//
// How: the reference becomes three disjoint sets of pairs, drawn from or weighed by the scene's
// distribution (reference.h). Each candidate (candidates.h) is fitted to the first. From the
// cheapest up, and of equal costs from the fewest parameters up, the second set decides
//
//   - who is on the front: who errs less than the front's last by more than chance, and by more
//   than
//     a hundredth of the tolerance. The difference of two errors over the same pairs, with the
//     standard error of a jackknife over blocks of pairs, must be below 0 with 99 % confidence; a
//     parameter, a lobe or an anisotropy that adds nothing leaves its candidate behind the simpler
//     one.
//   - who is worth trying: whose error's upper bound (95 %) is below the tolerance.
//
// The first of these is rounded to as few digits as cost no more than a hundredth of the tolerance,
// and certified on the third set: it is chosen if the upper bound of its error is below the
// tolerance. The n-th candidate that is tried gets the 2^-n-th part of 1 - confidence, so that with
// all of them together a choice misses the tolerance no more often than that.
//
// Errors are against the reference as it is, its noise included. The same input and seed give the
// same choice, but for costs that are measured. Thread safety: runs on the thread that calls it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/data/data.h"
#include "gonio/engine/material.h"
#include "gonio/select/selection.h"
#include "select/cost.h"
#include "select/error/error.h"
#include "select/reference.h"
#include "select/scene.h"

namespace gonio::select {

struct Options {
  bool whole_front = true;  // false: candidates above the choice's cost are not fitted
  int lobes = 2;            // at most so many specular lobes: 1 or 2
  CostTable costs;          // ns of parts; empty: measured here
  SetSizes sizes;
  std::size_t starts = 3;  // of each fit, as fit::Options has them
  std::uint64_t seed = 1;
  std::function<void(const std::string& name, std::size_t done, std::size_t of)> progress;
  std::function<bool()> stop;  // asked often; true ends all with `cancelled`
};

using Entry = EntryOf<MaterialSpec>;
using Choice = ChoiceOf<MaterialSpec>;
// Without Options::whole_front its entries are those up to the choice, and the reference.
using Selection = SelectionOf<MaterialSpec>;

// Are they options? Errors name "options....".
Outcome check(const Options& options);
// About what a selection from a reference of so many channels holds, in bytes.
std::size_t memory_of(int channels, const Scene& scene, const Options& options);

// Errors: invalid_argument naming "scene...", "options..." or "reference" (too few usable pairs in
// the scene, nothing that reflects); cancelled. That nothing is good enough is no error.
Result<Selection> choose(const fit::Data& reference, const Scene& scene, const Options& options);
// The reference itself is the last candidate.
Result<Selection> choose(const Material& reference, const Scene& scene, const Options& options);

}  // namespace gonio::select
