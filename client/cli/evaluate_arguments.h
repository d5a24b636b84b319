// The arguments of `gonio evaluate`. Thread safety: plain values.
#pragma once

#include <string>

#include "base/result.h"
#include "client/cli/connection.h"
#include "client/cli/result_writer.h"
#include "client/types.h"

namespace gonio::cli {

struct EvaluateArguments {
  ConnectionOptions connection;
  std::string material;
  std::string pairs;  // a file or "-"; empty with a grid
  std::string grid;
  std::string precision = "fast";
  std::string isa = "auto";
  std::string format;  // empty: by the output's extension
  std::string output = "-";
  bool degrees = false;
  bool with_input = false;
  bool quiet = false;
  bool verbose = false;
};

void add_evaluate_options(CLI::App& command, EvaluateArguments& arguments);

// The format asked for, or that of the output's extension, or CSV. Errors: what does not go
// together.
Result<Format> chosen_format(const EvaluateArguments& arguments);

}  // namespace gonio::cli
