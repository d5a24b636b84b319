// The unit in which a fit works: data in any unit, photocurrents of 1e-12 or counts of 1e9, are
// fitted as those of a material are.
#pragma once

#include "fit/data/data.h"
#include "gonio/base/result.h"

namespace gonio::fit {

// The weighted mean of m cos, or of m; 0 without pairs.
double mean_of(const Data& data, bool cosine);

// 1 for data whose weighted mean of m cos (or of m) is that of reflectance: 2^-10 to 2^6. Else the
// power of two that brings the mean to between 2^-4 and 2^-3. 1 if all values are 0.
double unit_of(const Data& data, bool cosine);

// The data with their values divided by `unit`, a power of two: exactly, but for what is too small
// for float32 beside the mean.
Data in_unit(Data data, double unit);

// Refuses data of which float32 holds less than its digits: all that is not 0 is subnormal, or
// would be.
Outcome check_size(double largest);
Outcome check_size(const Data& data);

}  // namespace gonio::fit
