// What is held against every model of the registry, present and future: functions that say what
// they found wrong, so that a test can show that they find planted errors, too.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "models/harness/analytic_models.h"
#include "models/oracle/draws.h"
#include "models/oracle/pairs.h"

namespace gonio::testing {

// A model as the checks see it: what it says of itself, and what it gives. Values are pair by pair,
// channel by channel.
struct Subject {
  ModelDescription description;
  std::function<std::vector<float>(const MaterialSpec&, const std::vector<DirectionPair<float>>&,
                                   Isa)>
      fast;
  std::function<std::vector<double>(const MaterialSpec&, const std::vector<DirectionPair<double>>&,
                                    Isa)>
      reference;
  // By the parameter of this name.
  std::function<std::vector<double>(const MaterialSpec&, const std::string& by,
                                    const std::vector<DirectionPair<double>>&, Isa)>
      derivative;
};

// The model of this name as the library has it.
Subject library_subject(std::string_view model);
std::vector<double> library_derivative(const MaterialSpec& spec, const std::string& by,
                                       const std::vector<DirectionPair<double>>& pairs, Isa isa);

// What is wrong, a line each; empty if nothing is. At most a few lines a check.
using Findings = std::vector<std::string>;

// All draw parameters from the model's own table (draws.h) and run every instruction set but where
// it cannot matter.
Findings check_description(const Subject&);  // complete, consistent, its start inside its bounds
Findings check_accuracy(const Subject&);     // fast and reference against the oracle
Findings check_reciprocity(const Subject&);
Findings check_rotation(const Subject&);     // isotropic draws do not change with the azimuth
Findings check_continuity(const Subject&);   // no jumps, along paths through every switch
Findings check_derivatives(const Subject&);  // against differences of the oracle
Findings check_energy(const Subject&);       // no albedo above the stated limit
// NaN, infinite or negative values, and fast against reference, over at least `evaluations`.
Findings check_proper(const Subject&, std::size_t evaluations);

// The albedos of white surfaces without a Fresnel factor: what a model loses or gains.
struct AlbedoRange {
  double lowest = 10, highest = 0;
  std::string lowest_at;
};
AlbedoRange white_albedos(const Subject&);
// The error of the quadrature for a constant, in units of what is allowed it.
double quadrature_error();

}  // namespace gonio::testing
