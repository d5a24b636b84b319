// An assessment as text for people. Thread safety: no state.
#pragma once

#include <string>

#include "gonio/client/assess.h"

namespace gonio::cli {

// A line for each place, for each incidence and for each check, and the verdict. `verbose`: below
// each place what is special there, what naive arithmetic does, and where the worst error is.
std::string assess_table(const client::Assessment& assessment, bool verbose);

}  // namespace gonio::cli
