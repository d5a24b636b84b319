// The result of an assessment. The assessment, the wire (proto/wire/mapping/assessment.h) and the
// client library use these structures. Thread safety: plain values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gonio/base/stated_bound.h"

namespace gonio::assess {

// A relative error, and where it is.
struct Worst {
  double error = 0;
  std::array<double, 3> wi{}, wo{};  // as they were given
  unsigned channel = 0;
  double value = 0, truth = 0;  // truth: the value that it was compared with
};

// The errors of one way of evaluating at one place.
struct Findings {
  std::uint64_t nan = 0, infinite = 0, negative = 0;
  // Values above the bound's `above` where truth is below it: light where there is none.
  std::uint64_t stray = 0;
  std::uint64_t checked = 0;  // values to which the relative bound applies
  // The worst of the checked ones. Where a difference crosses 0, the effect of four roundings of
  // its parameters is subtracted.
  Worst worst;

  [[nodiscard]] std::uint64_t improper() const { return nan + infinite + negative; }
};

struct PlaceReport {
  std::string name, where, failure;  // "near_mirror"; what is special; what naive arithmetic does
  std::uint64_t pairs = 0;
  Findings fast, reference;  // reference: of pairs in float64
  // The naive form with the pairs of `fast`, in float32 and in float64; none where no such form is
  // known.
  std::optional<Findings> naive32, naive64;
  Worst reciprocity;  // |f(wi, wo) - f(wo, wi)| over the larger, fast; `truth`: the other value
};

// One direction of incidence: energy by quadrature over wo, and samples against it.
struct Incidence {
  double theta = 0, phi = 0;           // radians
  std::vector<double> albedo;          // of each channel
  std::vector<double> sampled;         // the same as the mean weight of samples
  std::vector<double> standard_error;  // of those, as the samples show it
  // The deviation of these means, with large weights capped, in standard errors that allow for such
  // weights (Bernstein's inequality). A deviation of z or more has a probability of at most 2
  // exp(-z^2 / 2).
  std::vector<double> deviation;
  double mass = 0;         // the integral of the pdf
  double lost = 0;         // the part of samples below the horizon
  double unsure = 0;       // of the quadrature, the largest of mass and albedos
  double probability = 1;  // of samples at least as far from the pdf, by chi-square
  Worst weight;            // weight pdf against f cos(theta_o), of fast samples
};

// One check. It passes if `value` is at most `limit`; "distribution", if it is at least `limit`.
struct Check {
  // "improper", "stray", "error_fast", "error_reference", "reciprocity", "energy_gain",
  // "energy_loss", "pdf_mass", "weights", "sampled_albedo", "distribution"; of a table "missing",
  // "missing_region", "zeros", "holes", "outlier", "extreme", too
  std::string name;
  double value = 0, limit = 0;
  bool passed = false;
  std::string where;  // of the worst: a place's name, "85 deg", a cell; empty if nowhere
  std::string note;   // what was left out, and why; mostly empty
};

struct Assessment {
  bool passed = false;  // all checks
  std::vector<Check> checks;
  std::vector<PlaceReport> places;
  std::vector<Incidence> incidences;
  int channels = 1;
  StatedBound fast, reference;  // the bounds that the material states
  double cpu_seconds = 0;
};

}  // namespace gonio::assess
