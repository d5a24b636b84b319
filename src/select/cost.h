// What an evaluation of a material costs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/material.h"
#include "fit/data.h"
#include "select/candidates.h"
#include "select/distribution.h"

namespace gonio::select {

// Nanoseconds of a candidate's parts, by name ("ggx:schlick"); a sum costs what its parts do.
using CostTable = std::map<std::string, double, std::less<>>;

// The part that stands for the reference itself, where that is a material.
inline constexpr std::string_view kReferencePart = "reference";

// From the table. Errors: a part that it has not, or that is not above 0, as "options.costs".
Result<double> ns_from(const CostTable& table, const std::vector<std::string>& parts);

// Measured here and now on the pairs of `data`: the best of several batches of at most 4096.
double measured_ns(const Material& material, const fit::Data& data, Precision precision);

// 1 + variance / mean^2 of a sample's weight, its channels averaged, over the wi of a scene: the
// second moment of what a path brings home from light that varies by itself as much as it is
// bright.
double relative_second_moment(const Material& material, const Distribution& scene,
                              std::uint64_t seed);

}  // namespace gonio::select
