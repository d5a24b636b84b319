// The quadrature over the hemisphere and the chi-square test of src/assess, by the tests' names.
#pragma once

#include "assess/chi_square.h"
#include "assess/hemisphere.h"

namespace gonio::testing {

using assess::Bin;
using assess::chi_square_probability;
using assess::Integrands;
using assess::sidak;
using assess::Subdivision;
using assess::upper_gamma;

}  // namespace gonio::testing
