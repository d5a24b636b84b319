// The models as a chapter of a manual. Thread safety: no state.
#pragma once

#include <string>

#include "gonio/client/models.h"

namespace gonio::cli {

// Three tables: the models, their parameters, and the presets.
std::string markdown(const client::Catalogue& catalogue);

}  // namespace gonio::cli
