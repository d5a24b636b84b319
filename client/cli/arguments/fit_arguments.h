// The arguments of `gonio fit`. Thread safety: plain values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/cli/connection/connection.h"
#include "gonio/base/result.h"
#include "gonio/client/fit.h"

namespace gonio::cli {

struct FitArguments {
  ConnectionOptions connection;
  std::string data;
  std::vector<std::string> models;
  std::string objective = "l1";
  std::string strategy = "auto";
  std::optional<std::string> base;  // a diffuse model, or "none"; else the plainest diffuse one
  int lobes = 1;
  double min_theta = 0, max_theta = 90;  // degrees
  unsigned starts = 6;
  std::uint64_t seed = 1;
  bool degrees = false;
  bool anisotropic = false;
  std::optional<double> rotation;  // degrees; as given
  bool polish = false;
  bool quiet = false;
  std::string output;                // empty: none
  std::vector<std::string> reports;  // of each kind at most one
};

void add_fit_options(CLI::App& command, FitArguments& arguments);
// Errors: the pairs' angles leave nothing, or are none.
Outcome check_angles(const FitArguments& arguments);
client::FitOptions fit_options(const FitArguments& arguments);

}  // namespace gonio::cli
