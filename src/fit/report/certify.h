// Judges what a search found.
#pragma once

#include "fit/search/search.h"

namespace gonio::fit {

// `data`: all of them, also outside the fitted angles.
FitResult certify(const SearchInput& input, const Data& data, Search search);

// For data without one pair that could be fitted.
FitResult nothing_to_fit(const Data& data, const Options& options);

}  // namespace gonio::fit
