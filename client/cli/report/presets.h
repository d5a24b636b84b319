// Presets: names that may stand in the place of a parameter's numbers. Thread safety: no state.
#pragma once

#include <string>
#include <vector>

#include "gonio/client/models.h"

namespace gonio::cli {

// Presets that several parameters share, of whichever models, are one list.
struct PresetList {
  std::vector<std::string> parameters;
  std::string partner;  // the parameter that must be given too; empty: none
  std::vector<client::PresetInfo> presets;
};

std::vector<PresetList> preset_lists(const client::Catalogue& catalogue);

// One line a preset.
std::string preset_table(const client::Catalogue& catalogue);
// {"presets": [{"name": ..., "parameters": [...], "partner": ..., "values": [...], "source": ...},
// ...]}
std::string preset_json(const client::Catalogue& catalogue);

}  // namespace gonio::cli
