// A selection's result on the wire. Thread safety: a function without state.
#pragma once

#include "gonio/v1/select.pb.h"
#include "select/select.h"

namespace gonio::server {

v1::SelectResult to_wire(const select::Selection& selection);

}  // namespace gonio::server
