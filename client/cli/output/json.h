// What the JSON of several commands has in common. Thread safety: functions without state.
#pragma once

#include <string>
#include <string_view>

#include "gonio/client/types.h"

namespace gonio::cli {

std::string json_string(std::string_view text);

// A report as an object. `of_samples`: it counts samples, of which some may be lost, not pairs.
std::string report_json(const client::Report& report, bool of_samples);

}  // namespace gonio::cli
