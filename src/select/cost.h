// What an evaluation of a material costs.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gonio/engine/material.h"
#include "select/error/distribution.h"

namespace gonio::select {

// Nanoseconds of parts, by name ("ggx:schlick"). A sum costs the sum of its parts.
using CostTable = std::map<std::string, double, std::less<>>;

// The name of the part for the reference itself, where that is a material.
inline constexpr std::string_view kReferencePart = "reference";

// A material and what it is made of.
struct Priced {
  std::vector<std::string> parts;
  Material material;
};

// Nanoseconds of an evaluation of each in float32, on one thread. The numbers come from the table
// or, where that is empty, from one race (timing/race.h), in which materials of the same parts are
// timed once. Errors: a part that the table lacks, or whose number is not above 0, as
// "options.costs"; cancelled, if `stop` returns true.
Result<std::vector<double>> ns_of(const std::vector<Priced>& priced, const CostTable& table,
                                  const std::function<bool()>& stop);

// 1 + variance / mean^2 of a sample's weight, averaged over channels and over the wi of a scene. It
// is the relative second moment of a path's contribution for incident light whose standard
// deviation equals its mean.
double relative_second_moment(const Material& material, const Distribution& scene,
                              std::uint64_t seed);

}  // namespace gonio::select
