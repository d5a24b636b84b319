// What an evaluation of a material costs.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gonio/engine/material.h"
#include "select/error/distribution.h"

namespace gonio::select {

// Nanoseconds of a candidate's parts, by name ("ggx:schlick"); a sum costs what its parts do.
using CostTable = std::map<std::string, double, std::less<>>;

// The part that stands for the reference itself, where that is a material.
inline constexpr std::string_view kReferencePart = "reference";

// A material and what it is made of.
struct Priced {
  std::vector<std::string> parts;
  Material material;
};

// Nanoseconds of an evaluation of each in float32, on one thread. From the table; or, where that is
// empty, measured here and now in one race (timing/race.h), those of the same parts as one. Errors:
// a part that the table has not, or that is not above 0, as "options.costs"; cancelled, if `stop`
// says so.
Result<std::vector<double>> ns_of(const std::vector<Priced>& priced, const CostTable& table,
                                  const std::function<bool()>& stop);

// 1 + variance / mean^2 of a sample's weight, its channels averaged, over the wi of a scene: the
// second moment of what a path brings home from light that varies by itself as much as it is
// bright.
double relative_second_moment(const Material& material, const Distribution& scene,
                              std::uint64_t seed);

}  // namespace gonio::select
