// From what a certificate found to the one word that says how far to trust a fit.
#pragma once

#include "fit/data/data.h"
#include "fit/form.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

// Sets verdict and reason; all else is there already.
void set_verdict(const Form& form, std::span<const double> parameters, const Data& fitted,
                 Certificate& report);

}  // namespace gonio::fit
