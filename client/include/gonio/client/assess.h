// What Client::assess takes and gives: limits in, findings and a verdict out.
//
//   auto result = client.assess(material, {.limits = {.gain = 0.01}});
//   if (result && !result->passed)
//     for (const auto& check : result->checks) ...
//
// Thread safety: plain values.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gonio/client/types.h"

namespace gonio::client {

// What is still allowed. NaN, infinite and negative values, and light where there is none, never
// are.
struct AssessLimits {
  // Relative errors of the precisions; if not given, the bounds that the material states.
  std::optional<double> error, reference_error;
  std::optional<double> reciprocity;   // if not given, twice the stated bound of Precision::fast
  std::optional<double> gain;          // albedo above 1; 0.001
  std::optional<double> loss;          // albedo below 1; 1, which allows any
  std::optional<double> mass;          // |integral of the pdf + lost mass - 1|; 0.005
  std::optional<double> weight_error;  // of weight pdf; the stated bound and four roundings
  std::optional<double> probability;   // the least of chi-square; 1e-6
  std::optional<double> deviation;     // of albedos by samples, in standard errors; 5
};

struct AssessOptions {
  AssessLimits limits;
  std::uint32_t pairs = 4000;  // at each place, 1 to 1,000,000
  std::uint64_t seed = 1;      // of pairs and samples, 1 or more
  InstructionSet instruction_set = InstructionSet::best;
  // In place of ClientOptions::deadline.
  std::optional<std::chrono::milliseconds> deadline;
};

// One thing that was asked for. `value` is at most `limit` where it passed; of "distribution", at
// least.
struct AssessCheck {
  // "improper", "stray", "error_fast", "error_reference", "reciprocity", "energy_gain",
  // "energy_loss", "pdf_mass", "weights", "sampled_albedo", "distribution"
  std::string name;
  double value = 0, limit = 0;
  bool passed = false;
  std::string where;  // of the worst: a place's name or an angle
};

// A relative error and where it is.
struct AssessWorst {
  double error = 0;
  std::array<double, 3> wi{}, wo{};  // as they were given
  unsigned channel = 0;
  double value = 0, truth = 0;  // truth: what it was compared with
};

// Values at one place, by one way of evaluating.
struct AssessFindings {
  std::uint64_t nan = 0, infinite = 0, negative = 0;
  std::uint64_t stray = 0;    // values of f where there is none
  std::uint64_t checked = 0;  // values that the error bounds speak of
  AssessWorst worst;          // of those
};

struct AssessPlace {
  std::string name, where, failure;  // "near_mirror"; what is special; what naive arithmetic does
  std::uint64_t pairs = 0;
  AssessFindings fast, reference;
  // The formula as a loop of one's own would have it, in float32 and in float64; none where no such
  // form is known.
  std::optional<AssessFindings> naive32, naive64;
  AssessWorst reciprocity;  // `truth`: the value of the exchanged directions
};

// Light from one direction.
struct AssessIncidence {
  double theta = 0, phi = 0;                    // radians
  std::vector<double> albedo;                   // of each channel, by quadrature
  std::vector<double> sampled, standard_error;  // the same by samples
  double mass = 0, lost = 0;                    // of the pdf, and below the horizon
  double unsure = 0;                            // of the quadrature
  double probability = 0;                       // of the samples, by chi-square
  AssessWorst weight;                           // weight pdf against f cos(theta_o)
};

struct Assessment {
  bool passed = false;  // all checks
  std::vector<AssessCheck> checks;
  std::vector<AssessPlace> places;
  std::vector<AssessIncidence> incidences;
  int channels = 0;
  ErrorBound fast, reference;  // what the material states
  InstructionSet instruction_set = InstructionSet::best;
  double cpu_seconds = 0;
  std::string json;  // all of it, as gonio.v1.AssessResponse, its fields named as in the .proto
};

}  // namespace gonio::client
