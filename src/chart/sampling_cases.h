// What is drawn from: materials, and how a textbook draws for them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "chart/cases.h"
#include "chart/textbook.h"

namespace gonio::chart {

using Vector64 = Vector<double>;

// Draws a whole batch: wi and xi as triples, wo and weights as triples, pdf. The model's colours
// are those of its form as printed.
using ScalarSampling = void (*)(const float* wi, const float* xi, std::size_t n, float* wo,
                                float* pdf, float* weights);

using DrawFunction = std::function<Vector64(const Vector64& wi, const Vector64& xi)>;
using PdfFunction = std::function<double(const Vector64& wi, const Vector64& wo)>;

struct SamplingCase {
  std::string name;
  MaterialSpec spec;
  DrawFunction draw;
  PdfFunction pdf;
  ScalarSampling scalar = nullptr;  // only for what is timed
};

// Every model as model_cases() has it.
std::vector<SamplingCase> timed_cases();
// With F = 1, where a bound was set to the variance of their weights at 75 degrees.
struct BoundedCase {
  SamplingCase material;
  double theta;    // degrees
  double azimuth;  // degrees
  double bound;
};
std::vector<BoundedCase> bounded_cases();

}  // namespace gonio::chart
