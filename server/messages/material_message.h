// A material as people write it, from the core's: the inverse of material_spec(). Thread safety: a
// function without state.
#pragma once

#include "gonio/engine/material.h"
#include "gonio/v1/material.pb.h"
#include "wire/mapping/mapping.h"

namespace gonio::server {

v1::Material to_wire(const MaterialSpec& spec);

}  // namespace gonio::server

namespace gonio::wire {

template <>
struct Mapping<MaterialSpec> {
  using Message = v1::Material;
  static void write(const MaterialSpec& from, Message& to) { to = server::to_wire(from); }
};

}  // namespace gonio::wire
