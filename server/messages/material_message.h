// A material as people write it, from the core's: the inverse of material_spec(). Thread safety: a
// function without state.
#pragma once

#include "gonio/engine/material.h"
#include "gonio/v1/material.pb.h"

namespace gonio::server {

v1::Material to_wire(const MaterialSpec& spec);

}  // namespace gonio::server
