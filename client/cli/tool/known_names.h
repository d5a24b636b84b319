// What this program knows of models by its own tables: names that a shell may complete, what fits
// take, and which parameter names a file. Thread safety: functions without state.
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

// A model's parameter that names a file; null if it has none.
const Parameter* file_parameter(std::string_view model);
// The first model that reads its values from a file: MERL's tables.
const ModelDescription& model_of_files();

}  // namespace gonio::cli
