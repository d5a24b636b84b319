// Albedos as text and as JSON. Thread safety: functions without state.
#pragma once

#include <string>
#include <vector>

#include "gonio/client/sampling.h"

namespace gonio::cli {

// A line for each wi: its angles in degrees, then albedo and standard error of each channel, and
// the lost fraction. A wi that could not be used has its flags in place of numbers.
std::string albedo_text(const std::vector<double>& wi, const client::Albedos& albedos);

// {"channels": N, "albedos": [{"wi": [...], "albedo": [...], "standard_error": [...], "lost": F,
// "flags": F}, ...], "report": {...}}.
std::string albedo_json(const std::vector<double>& wi, const client::Albedos& albedos);

}  // namespace gonio::cli
