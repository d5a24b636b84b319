// How far a parameter can be moved before the fit suffers, the others following.
#pragma once

#include <vector>

#include "fit/search/search.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

// For each shape parameter that bends a lobe without widening it: those of its values over the
// scan's range that come within 1 % of the best objective. The curvature at the optimum cannot know
// of another basin; this does.
std::vector<Profile> profiles_of(const SearchInput& input, std::span<const double> parameters);

}  // namespace gonio::fit
