// What select_bench says of measured materials. Prints Markdown.
#pragma once

#include <string_view>

namespace gonio::bench {

// Choices at three tolerances for a scene with views to 75 degrees, against the measured table and
// the model that fits best: a table to read, and one with everything.
// Of materials with `part` in their names.
bool print_choices(std::string_view part);

// Choices for a scene that looks only from near the normal and for one that also looks from grazing
// angles, and what is said of them.
bool print_by_view();

}  // namespace gonio::bench
