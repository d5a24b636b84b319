// The arguments of `gonio evaluate`. Thread safety: plain values.
#pragma once

#include <string>

#include "client/cli/arguments/common_arguments.h"
#include "gonio/base/result.h"

namespace gonio::cli {

struct EvaluateArguments : CommonArguments {
  std::string pairs;  // a file or "-"; empty with a grid
  std::string grid;
  bool degrees = false;
  bool with_input = false;
  bool pdf = false;
};

void add_evaluate_options(CLI::App& command, EvaluateArguments& arguments);

// The format of the results. Errors: what does not go together.
Result<Format> checked_format(const EvaluateArguments& arguments);

}  // namespace gonio::cli
