// Functions of whole arrays, several numbers at a time.
#pragma once

#include <Eigen/Core>

namespace gonio::fit {

// To about 1e-15; 0 where x is below 1e-30, whose root has an infinite slope nearby: 1e-10.
template <class Derived>
auto cube_root(const Eigen::ArrayBase<Derived>& x) {
  return (x.max(1e-30).log() / 3).exp();
}

}  // namespace gonio::fit
