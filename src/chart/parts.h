// The parts of a chart by name, in one call, for the command line and the server. Thread safety: as
// chart.h.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "chart/chart.h"

namespace gonio::chart {

struct Part {
  std::string_view name;  // "models"
  bool of_a_material;     // whether the part is about a measured material
};

// "models", "fits", "approximations", "directions", "sampling", "resolution".
std::span<const Part> all_parts();

struct Wanted {
  std::vector<std::string> parts;    // by name; empty: all
  std::optional<Measured> measured;  // not given: example_table()
};

// Checks that the parts exist and that the effort is within its bounds (1 to 1000 repetitions of up
// to 0.1 s, 1 to 20,000 pairs). Errors name the field: "parts[1]", "repetitions", "seconds",
// "pairs".
Outcome check(const std::vector<std::string>& parts, const Options& options);

// Whether one of the wanted parts needs a measured material.
bool needs_material(const std::vector<std::string>& parts);

// The tables of the wanted parts in the order of all_parts(). `progress` is called with a part's
// name and the share of the whole that is done; Options::progress is not called. Without a table in
// `measured` the part resolution is left out. Errors: as check(); "parts" where resolution is asked
// for by name and there is no table; `cancelled`.
Result<std::vector<Table>> measure(
    const Wanted& wanted, const Options& options,
    const std::function<void(std::string_view part, double done)>& progress = {});

// The approximate peak memory in bytes, without the measured data.
std::size_t memory_of(const std::vector<std::string>& parts, const Options& options);

}  // namespace gonio::chart
