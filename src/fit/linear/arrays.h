// Functions of whole arrays, many numbers at a time; their errors are those of array_kernels.h.
#pragma once

#include <Eigen/Core>

#include "fit/linear/array_kernels.h"

namespace gonio::fit {

inline Eigen::ArrayXd log_1p(Eigen::ArrayXd x) {
  array_kernels().log_1p(x.data(), static_cast<std::size_t>(x.size()), x.data());
  return x;
}
inline Eigen::ArrayXd cube_root(Eigen::ArrayXd x) {
  array_kernels().cube_root(x.data(), static_cast<std::size_t>(x.size()), x.data());
  return x;
}

}  // namespace gonio::fit
