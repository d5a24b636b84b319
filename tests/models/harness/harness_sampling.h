// What is held against every material's sampler: functions that say what they found wrong, so that
// a test can show that they find planted errors, too.
#pragma once

#include "models/harness/harness.h"
#include "models/sampling/sampling_cases.h"
#include "models/sampling/sampling_subject.h"

namespace gonio::testing {

// A sampler's density and values, integrated over the hemisphere at one place: columns are the pdf,
// f cos(theta_o) of every channel, and (f cos(theta_o))^2 / pdf of every channel, the weight's
// second moment.
struct Integrated {
  Subdivision subdivision;
  std::vector<Bin> bins;
  double lost;         // the mass of samples below the horizon, by a regular grid of their numbers
  bool blurs_float32;  // whether float32's steps are seen in the bins, so narrow is the lobe
};
Integrated integrate(const SamplingSubject<double>& subject, const Place& place);

// The integral of the pdf and the lost mass are 1 together.
Findings check_total(const Integrated& integrated);

// Samples are where the integrated pdf says: chi-square, at this level; not asked of float32 where
// it would only show its steps. What fails leaves both densities as a file, whose name it tells.
template <class T>
Findings check_distribution(const SamplingSubject<T>& subject, const Place& place,
                            const Integrated& integrated, double level);

// The mean weight is the albedo, within four standard errors and the quadrature's own. The standard
// error is that of the quadrature's second moment: rare weights hardly show in that of the samples.
template <class T>
Findings check_albedo(const SamplingSubject<T>& subject, const Place& place,
                      const Integrated& integrated);

// weight pdf = f cos(theta_o) within the bound that the models state for f, pdf = the papers'
// density (density_oracle.h) within the same (5e-6 in float32); `evaluate` gives the same pdf and
// the same f as without a sampler, bit for bit.
template <class T>
Findings check_samples(const SamplingSubject<T>& subject, const Place& place, Isa isa);

}  // namespace gonio::testing
