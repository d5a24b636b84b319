// A fit's result on the wire. Thread safety: a function without state.
#pragma once

#include "fit/fit.h"
#include "gonio/v1/fit.pb.h"

namespace gonio::server {

v1::FitResult to_wire(const fit::FitResult& result);

}  // namespace gonio::server
