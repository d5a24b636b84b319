// Names that a shell may complete. Thread safety: functions without state.
#pragma once

#include <string>
#include <vector>

namespace gonio::cli {

// The models' names.
std::vector<std::string> model_names();
// What `gonio fit --model` takes: models, with each Fresnel term, and "all".
std::vector<std::string> fitted_names();

}  // namespace gonio::cli
