// What `gonio compare` compares: measurements and materials, read and built. Thread safety: no
// state.
#pragma once

#include <string>
#include <vector>

#include "chart/chart.h"
#include "client/cli/input/measured_input.h"
#include "fit/data/data.h"
#include "gonio/base/result.h"
#include "gonio/client/material.h"
#include "gonio/engine/material.h"

namespace gonio::cli {

// A material by its name in tables and pictures.
struct Compared {
  std::string name;
  client::Material asked;  // as the service takes it
  Material material;       // the same, built
};

struct Comparison {
  MeasuredInput input;
  fit::Data data;  // the same, as metrics take it
  std::vector<Compared> compared;
};

// `arguments` are those of --material. Errors name the file or the option: what cannot be read or
// built, and materials of other channels than the reference has.
Result<Comparison> read_comparison(const std::string& reference,
                                   const std::vector<std::string>& arguments, bool degrees);

// A file's measurements as a chart takes them, with the table if it is one. Errors name the file.
Result<chart::Measured> read_chart_data(const std::string& file, bool degrees);

// A file's name, or JSON as it is.
std::string shown_name(const std::string& argument);

}  // namespace gonio::cli
