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
#include <variant>
#include <vector>

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

struct ChartProgress {
  std::string stage;  // "queued", or the part that is being measured
  double done = 0;    // of all parts, 0 to 1
};

// Both are called on the thread that called chart().
struct ChartWatch {
  std::function<void(const ChartProgress&)> progress;  // several times a second
  std::function<bool()> stop;  // asked about 20 times a second; true ends it with `cancelled`
};

struct ChartMachine {
  std::string processor;
  unsigned cores = 0;
  std::vector<std::string> instruction_sets;
  std::string gonio, compiler, system;
};

struct ChartColumn {
  std::string name, unit, meaning;  // no unit: words
};

// A row is a choice; its cells are words, or numbers: NaN where there is none. 1 in the column
// "front" marks what no other one beats.
using ChartCell = std::variant<std::string, double>;
struct ChartTable {
  std::string name, title;  // the name is of small letters, digits and '_'
  std::vector<ChartColumn> columns;
  std::vector<std::vector<ChartCell>> rows;
};

struct Chart {
  ChartMachine machine;
  std::vector<ChartTable> tables;
};

}  // namespace gonio::client
