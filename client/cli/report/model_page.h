// Models as text for people. Thread safety: no state.
#pragma once

#include <string>
#include <string_view>

#include "gonio/client/models.h"

namespace gonio::cli {

std::string_view role_word(client::Role role);

// One line a model, the stored materials, the processor's instruction sets.
std::string model_table(const client::Catalogue& catalogue);

// A manual page: meaning, source, accuracy, parameters, an example.
std::string model_page(const client::ModelInfo& model);

}  // namespace gonio::cli
