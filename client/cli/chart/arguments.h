// The arguments of `gonio chart`. Thread safety: plain values.
#pragma once

#include <string>
#include <vector>

#include "chart/parts.h"
#include "client/cli/connection/connection.h"

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

// What the command line calls a part of the core's: the types on the wire belong to its wire.
std::string name_of(const chart::Part& part);

void add_chart_options(CLI::App& command, ChartArguments& arguments);

}  // namespace gonio::cli
