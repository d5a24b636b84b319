// What a selection found, for people and for programs. Thread safety: no state.
#pragma once

#include <string>

#include "select/select.h"

namespace gonio::cli {

// The front (or all candidates), one line each, the choice marked, and why.
std::string select_table(const select::Selection& selection, bool all);

// All that is known, as a JSON object.
std::string select_json(const select::Selection& selection);

// A material as people write it.
std::string material_json(const MaterialSpec& spec);

}  // namespace gonio::cli
