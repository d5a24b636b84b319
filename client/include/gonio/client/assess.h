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
  std::optional<double> gain;          // albedo above 1; 0.001, of a table up to 87 degrees
  std::optional<double> loss;          // albedo below 1; 1, which allows any
  std::optional<double> mass;          // |integral of the pdf + lost mass - 1|; 0.005
  std::optional<double> weight_error;  // of weight pdf; the stated bound and four roundings
  // The least of chi-square; and AssessIncidence::deviation. If not given: such that a good
  // material fails by chance in one of 1000 assessments.
  std::optional<double> probability, deviation;
  // Of a table's cells within 80 degrees: the share without a measurement, 0.1; the same in the
  // worst range of an angle, 0.5; the share that holds 0, 0.5; the share of masked ones, far darker
  // than what is on both sides of them, 0.001.
  std::optional<double> missing, missing_region, zeros, holes;
  // Of all its cells: times as bright as what is about them, 100; f cos cos in 1/sr, 100000.
  std::optional<double> outlier, extreme;
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
  // "energy_loss", "pdf_mass", "weights", "sampled_albedo", "distribution"; of a table "missing",
  // "missing_region", "zeros", "holes", "outlier", "extreme", too
  std::string name;
  double value = 0, limit = 0;
  bool passed = false;
  std::string where;  // of the worst: a place's name, an angle, a cell
  std::string note;   // what was not judged, and why
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
  // Of each channel: how far `sampled` is off, with rare large weights cut, in standard errors that
  // such weights widen: z or more has a probability of 2 exp(-z^2 / 2) or less.
  std::vector<double> deviation;
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
