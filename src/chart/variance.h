// The variance of the weights of samplers and of textbook strategies. Thread safety: functions
// without state.
#pragma once

#include <cstdint>

#include "chart/sampling_cases.h"
#include "gonio/engine/sampler.h"

namespace gonio::chart {

// Of the weights averaged over the channels.
struct Variance {
  double variance = 0;
  double mean = 0;  // the albedo
  double lost = 0;  // the part of samples below the horizon, which count as 0
};

// The number of scrambled Sobol' points by which it is estimated.
struct VarianceEffort {
  std::size_t points = std::size_t{1} << 19U;
  std::uint64_t seed = 1;
};

Vector64 direction(double theta_degrees, double azimuth_degrees);

// The variance of the material's own sampler.
Variance own_variance(const Material& material, const Vector64& wi, const VarianceEffort& effort);
// The variance of another strategy's directions and densities, with the library's f.
Variance variance_of(const DrawFunction& draw, const PdfFunction& pdf, const Material& material,
                     const Vector64& wi, const VarianceEffort& effort);

}  // namespace gonio::chart
