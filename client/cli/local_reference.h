// Materials and measurements for the commands that work in this process. Thread safety: no state.
#pragma once

#include "base/result.h"
#include "client/cli/measured_input.h"
#include "client/material.h"
#include "engine/material.h"
#include "fit/data.h"
#include "server/materials.h"

namespace gonio::cli {

// The material built.
Result<Material> local_material(const Materials& materials, const client::Material& material);

// What was read, as fits and metrics take it.
Result<fit::Data> local_data(const Materials& materials, const MeasuredInput& input);

}  // namespace gonio::cli
