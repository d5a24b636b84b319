// The columns of the input, put before the results (--with-input). Thread safety: used by one
// thread.
#pragma once

#include "client/cli/arguments/grid_spec.h"
#include "client/cli/input/pair_input.h"
#include "client/cli/output/result_writer.h"

namespace gonio::cli {

// The angles as they were given, degrees or radians. `spec` must outlive what comes back.
template <class T>
InputColumns<T> grid_columns(const GridSpec& spec);

// The directions, or the angles if the input gave those. `input` must outlive what comes back.
template <class T>
InputColumns<T> pair_columns(PairInput<T>& input);

}  // namespace gonio::cli
