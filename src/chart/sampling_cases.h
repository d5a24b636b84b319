// Materials to sample, and how textbooks sample them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "chart/cases.h"
#include "chart/textbook.h"

namespace gonio::chart {

using Vector64 = Vector<double>;

// Draws a whole batch: wi and xi as triples, wo and weights as triples, pdf. The colours are those
// of the printed form.
using ScalarSampling = void (*)(const float* wi, const float* xi, std::size_t n, float* wo,
                                float* pdf, float* weights);

using DrawFunction = std::function<Vector64(const Vector64& wi, const Vector64& xi)>;
using PdfFunction = std::function<double(const Vector64& wi, const Vector64& wo)>;

struct SamplingCase {
  std::string name;
  MaterialSpec spec;
  DrawFunction draw;
  PdfFunction pdf;
  ScalarSampling scalar = nullptr;  // null where it is not timed
};

// A case for each of model_cases().
std::vector<SamplingCase> timed_cases();
// Cases with F = 1, for which tests bound the variance of the weights at 75 degrees.
struct BoundedCase {
  SamplingCase material;
  double theta;    // degrees
  double azimuth;  // degrees
  double bound;
};
std::vector<BoundedCase> bounded_cases();

}  // namespace gonio::chart
