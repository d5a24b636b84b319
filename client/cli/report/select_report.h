// What selections found, for people and for programs. Thread safety: no state.
#pragma once

#include <string>
#include <vector>

#include "gonio/client/select.h"

namespace gonio::cli {

// A material's name in its scene, and what was found for it.
struct NamedSelection {
  std::string name;  // empty: the only one
  client::Selection selection;
};

// The front (or all candidates), one line each, the choice marked, and why.
std::string select_table(const client::Selection& selection, bool all);

// A line for each material of a scene: the reference and the choice, what they cost and how far off
// the choice is; and what all choices save together.
std::string scene_table(const std::vector<NamedSelection>& materials);

// All that is known, as a JSON object: gonio.v1.SelectResult, or one by each name.
std::string select_json(const std::vector<NamedSelection>& materials);

}  // namespace gonio::cli
