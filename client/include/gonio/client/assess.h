// What Client::assess takes and gives: limits in, findings and a verdict out.
//
//   auto result = client.assess(material, {.limits = {.gain = 0.01}});
//   if (result && !result->passed)
//     for (const auto& check : result->checks) ...
//
// Thread safety: plain values.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "gonio/assess/report.h"
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

// What was found, and the verdict.
using AssessCheck = gonio::assess::Check;
using AssessFindings = gonio::assess::Findings;
using AssessIncidence = gonio::assess::Incidence;
using AssessPlace = gonio::assess::PlaceReport;
using AssessWorst = gonio::assess::Worst;
struct Assessment : gonio::assess::Assessment {
  InstructionSet instruction_set = InstructionSet::best;  // that it was answered with
  std::string json;  // all of it, as gonio.v1.AssessResponse, its fields named as in the .proto
};

}  // namespace gonio::client
