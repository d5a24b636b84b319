// Materials and measurements for the commands that work in this process. Thread safety: no state.
#pragma once

#include <string>

#include "base/result.h"
#include "engine/material.h"
#include "fit/data.h"
#include "server/materials.h"

namespace gonio::cli {

// As read_material() takes it, built.
Result<Material> local_material(const Materials& materials, const std::string& argument);

// As read_measured() takes it; `degrees`: a CSV's angles are.
Result<fit::Data> local_data(const Materials& materials, const std::string& file, bool degrees);

}  // namespace gonio::cli
