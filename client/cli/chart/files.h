// The files of a chart: each appears as a whole or not at all. Thread safety: functions without
// state.
#pragma once

#include <string>

#include "client/cli/chart/tables.h"
#include "gonio/base/result.h"

namespace gonio::cli {

// Makes the folder where it is not there, and sees that files can be written to it.
Outcome make_folder(const std::string& folder);

// chart.json, and a CSV a table.
Outcome write_tables(const std::string& folder, const Chart& chart);

// A script, an SVG and a PNG a figure. Errors: without gnuplot, that it is missing; the scripts are
// written.
Outcome write_figures(const std::string& folder, const Chart& chart);

// What there is, for people.
std::string summary_of(const std::string& folder, const Chart& chart);

}  // namespace gonio::cli
