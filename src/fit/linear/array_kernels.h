// What sums over pairs spend their time on, compiled once per instruction set: plain tables of
// functions of arrays of float64.
//
// Nothing here has code: this header is read by objects of different instruction sets. Arrays need
// no alignment and may be of any length.
#pragma once

#include <cstddef>

#include "fit/linear/objective.h"

namespace gonio::fit {

// A run of pairs in one channel: f and measured m, whose transform (objective.h) is given.
struct ResidualRun {
  std::size_t count;
  const double *f, *cosine, *weight, *measured;
  double smooth, threshold;  // of Loss
  // The residual e, de/df, and the root of what least squares weighs e^2 by.
  double *residual, *slope, *root;
};

struct ArrayKernels {
  // log(1 + x), x > -1/2, and x^(1/3), x >= 0: to 2e-15 + 2e-16 absolute, and to 1e-15. The root is
  // 1.2e-10 below 1.6e-30, where its slope would be without bound.
  void (*log_1p)(const double* x, std::size_t count, double* to);
  void (*cube_root)(const double* x, std::size_t count, double* to);
  // By objective, in the order of Objective: fills the three results, and gives the weighted sum of
  // losses.
  double (*residuals[kObjectiveCount])(const ResidualRun& run);
};

// Of the best instruction set that this processor has.
const ArrayKernels& array_kernels();

}  // namespace gonio::fit

namespace gonio::baseline {
extern const fit::ArrayKernels kArrayKernels;
}
namespace gonio::avx2 {
extern const fit::ArrayKernels kArrayKernels;
}
namespace gonio::avx512 {
extern const fit::ArrayKernels kArrayKernels;
}
