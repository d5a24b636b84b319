// Names that a shell may complete. Thread safety: functions without state.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gonio/models/description.h"

namespace gonio::cli {

// The models' names.
std::vector<std::string> model_names();
// What `gonio fit --model` takes: models, with each word of their choice_in_fits(), and "all".
std::vector<std::string> fitted_names();

// By this program's own tables, which a server of another version may have others of: the
// parameter whose word may follow a model's name there, as "ggx:schlick" has it; null if none.
const Parameter* choice_in_fits(std::string_view model);
// Whether fits take a model. Of a model that these tables do not have the server decides.
bool is_fitted(std::string_view model);

}  // namespace gonio::cli
