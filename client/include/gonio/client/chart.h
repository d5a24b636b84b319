// What Client::chart takes and gives: speed against accuracy, measured on the server's machine.
//
//   auto chart = client.chart({.parts = {"models"}});
//   for (const auto& row : chart->tables[0].rows) ...
//
// Thread safety: plain values.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gonio/chart/table.h"
#include "gonio/client/fit.h"

namespace gonio::client {

struct ChartOptions {
  // "models", "fits", "approximations", "directions", "sampling", "resolution"; empty: all.
  std::vector<std::string> parts;
  // For fits and resolution, the latter of a measured table only; none: the server makes one up.
  std::optional<FitData> data;
  unsigned repetitions = 25;         // of each time, 1 to 1000
  double seconds = 0.004;            // that a repetition takes at least, 1e-6 to 0.1
  unsigned pairs_at_a_place = 5000;  // where errors are looked for, 1 to 20,000
  std::uint64_t seed = 1;            // of these pairs, 1 or more
  // In place of ClientOptions::deadline.
  std::optional<std::chrono::milliseconds> deadline;
};

using ChartProgress = gonio::chart::Progress;

// Both are called on the thread that called chart().
struct ChartWatch {
  std::function<void(const ChartProgress&)> progress;  // several times a second
  std::function<bool()> stop;  // asked about 20 times a second; true ends it with `cancelled`
};

using ChartMachine = gonio::chart::Machine;
using ChartColumn = gonio::chart::Column;
using ChartCell = gonio::chart::Cell;
using ChartTable = gonio::chart::Table;
using Chart = gonio::chart::Chart;

}  // namespace gonio::client
