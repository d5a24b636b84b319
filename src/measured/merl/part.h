// A measured table as a part of a material. Thread safety: immutable.
#pragma once

#include <memory>

#include "gonio/engine/material.h"
#include "gonio/measured/table.h"
#include "kernels/part.h"

namespace gonio {

Part merl_part(std::shared_ptr<const MeasuredTable> table, Interpolation interpolation);

}  // namespace gonio
