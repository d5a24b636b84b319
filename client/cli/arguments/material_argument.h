// The --material argument: inline JSON, a file, or the name of a stored material. Thread safety: no
// state.
#pragma once

#include <string>

#include "gonio/base/result.h"
#include "gonio/client/material.h"

namespace gonio::cli {

// In this order: what starts with '{' is JSON; "-" is JSON on standard input; "@FILE" and what ends
// in .json or .binary or has a '/' is a file, and so is what is there and holds a material (JSON,
// or a MERL table: its content decides); anything else is the name of a material that the server
// holds, or of a substance (server/materials/preset_material.h). Files that only this machine has
// can be used by an `embedded` server alone. Errors name the file and what is wrong; of a file of
// another kind they say what takes it.
Result<client::Material> read_material(const std::string& argument, bool embedded);

}  // namespace gonio::cli
