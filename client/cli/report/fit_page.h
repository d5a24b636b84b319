// All that is known of fits as a page for people, in Markdown. Thread safety: no state.
#pragma once

#include <string>
#include <vector>

#include "client/cli/arguments/fit_arguments.h"
#include "client/cli/report/fit_table.h"

namespace gonio::cli {

// What was fitted to what and how, a table of all fits, and a section for each: verdict, errors by
// zone, parameters with their intervals, what the data cannot tell apart, how the optimum was
// found, where the material is far off, and what it cost.
std::string fit_page(const std::vector<NamedFit>& fits, const FitArguments& arguments);

}  // namespace gonio::cli
