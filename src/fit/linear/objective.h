// What a fit minimises: residuals, losses and the weights that iterated least squares gives them.
//
// With cos the cosine of incidence, the residual e of a value f against a measured m is
//   l1, l2, huber:  (f - m) cos        log: log(1 + f cos) - log(1 + m cos)
//   cbrt:           cbrt(f cos) - cbrt(m cos)
// f and m in 1/sr or, where the data are far from the size of reflectance, in a unit of their own
// (unit.h): all but log are of the same optimum in any unit.
// and the loss |e| for l1 and log, e^2 / 2 for l2 and cbrt, and Huber's of a threshold. |e| is
// minimised as sqrt(e^2 + smooth^2), smooth going to 0 by stages.
#pragma once

#include "gonio/fit/objective.h"

namespace gonio::fit {

struct Loss {
  Objective objective = Objective::l1;
  double smooth = 0;     // for l1 and log, in the residual's unit
  double threshold = 1;  // for huber, in the residual's unit

  [[nodiscard]] bool absolute() const {
    return objective == Objective::l1 || objective == Objective::log;
  }
  // What measured values are kept as: the transform of m cos.
  [[nodiscard]] double transformed(double value_times_cosine) const;
  // of e
  [[nodiscard]] double loss(double e) const;
  // d(loss)/de / e: what least squares weighs e^2 by to have the loss's gradient.
  [[nodiscard]] double weight(double e) const;
};

}  // namespace gonio::fit
