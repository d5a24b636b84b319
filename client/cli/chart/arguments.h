// The arguments of `gonio chart`. Thread safety: plain values.
#pragma once

#include <string>
#include <vector>

#include "client/cli/connection.h"

namespace gonio::cli {

struct ChartArguments {
  ConnectionOptions connection;
  std::string folder;
  std::string data;  // empty: generated
  bool degrees = false;
  std::vector<std::string> parts;  // empty: all
  bool quick = false;
  bool quiet = false;

  [[nodiscard]] bool wants(const std::string& part) const;
};

void add_chart_options(CLI::App& command, ChartArguments& arguments);

}  // namespace gonio::cli
