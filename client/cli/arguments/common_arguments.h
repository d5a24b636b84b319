// The arguments that all commands with a material share. Thread safety: plain values.
#pragma once

#include <string>

#include "client/cli/connection/connection.h"
#include "client/cli/output/result_writer.h"
#include "gonio/client/client.h"

namespace gonio::cli {

// For a command's footer: what --material takes.
extern const char* const kMaterialHelp;
// What the flags' bits mean.
extern const char* const kFlagHelp;

struct CommonArguments {
  ConnectionOptions connection;
  std::string material;
  std::string precision = "fast";
  std::string isa = "auto";
  std::string format;  // empty: by the output's extension
  std::string output = "-";
  bool quiet = false;
  bool verbose = false;

  [[nodiscard]] bool is_reference() const { return precision == "reference"; }
  [[nodiscard]] client::EvaluateOptions evaluate_options() const;
};

// --material, alone. `what`: its help.
void add_material_option(CLI::App& command, std::string& material, const std::string& what);
// --material, --precision, --isa, and those of the connection.
void add_material_options(CLI::App& command, CommonArguments& arguments);
// --format, --output, --quiet, --verbose. `items`: "pairs".
void add_result_options(CLI::App& command, CommonArguments& arguments, const std::string& items);

// The format asked for, or that of the output's extension, or CSV. Errors: NPY for a terminal.
Result<Format> chosen_format(const CommonArguments& arguments);

}  // namespace gonio::cli
