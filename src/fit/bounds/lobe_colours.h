// Which parameters of a model are the colours of a lobe, by what its table says of them.
#pragma once

#include "engine/material/lobe_check.h"
#include "fit/bounds/colour.h"
#include "gonio/base/result.h"

namespace gonio::fit {

// A number of each channel that a fit solves for, used with the lobe's words?
bool is_fitted_colour(const CheckedLobe& lobe, const Parameter& p);

// `named` is what errors call the lobe. In a sum it has no base colour beside its own lobe. Errors:
// colours that a fit cannot tell apart, or whose bounds it cannot hold, by their field.
Result<LobeColours> lobe_colours(const CheckedLobe& lobe, const NamedLobe& named);

}  // namespace gonio::fit
