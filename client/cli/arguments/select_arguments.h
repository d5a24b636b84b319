// The arguments of `gonio select`. Thread safety: plain values.
#pragma once

#include <string>

#include "client/cli/connection/connection.h"
#include "gonio/client/select.h"

namespace gonio::cli {

struct SelectArguments {
  ConnectionOptions connection;
  std::string reference, scene, costs, output, report;
  bool degrees = false, all = false, no_front = false, quiet = false;
  client::SelectOptions options;
};

void add_select_options(CLI::App& command, SelectArguments& arguments);

}  // namespace gonio::cli
