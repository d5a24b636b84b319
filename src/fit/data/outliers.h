// Values that no reflectance could be among the others of the same data: a fit by absolute errors
// follows them and nothing else. Thread safety: functions without state.
#pragma once

#include <string>

#include "fit/data/data.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

// "1 value of channel 0 is far out: 1e+30 1/sr at theta_i 30, theta_o 45 degrees, 3e+24 times the
// next"; empty if there is none. Values of a lobe, however sharp, follow each other: far out is
// what is more than 1000 times the next smaller one, among the largest 0.1 % (and at least three).
std::string outliers_of(const Data& data);

// Says so in the certificate's reason. A fit that `converged` on it has failed, unless the
// objective is of logarithms.
void judge_outliers(const Data& data, Certificate& certificate);

}  // namespace gonio::fit
