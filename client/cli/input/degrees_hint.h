// Notes on stderr where angles look like degrees that were taken for radians, because --deg is
// missing. Thread safety: functions without state.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/cli/arguments/grid_spec.h"
#include "client/cli/input/pair_input.h"

namespace gonio::cli {

// Axes with theta beyond pi/2 or phi beyond 2 pi.
void hint_at_degrees(const GridSpec& grid);

// Measured pairs, from angles, of which a quarter and more have a direction below the horizon.
void hint_at_degrees(const std::vector<float>& wi, const std::vector<float>& wo,
                     const std::string& file);

// The same input, with a note about its first such angle.
template <class T>
std::unique_ptr<PairInput<T>> hinting_at_degrees(std::unique_ptr<PairInput<T>> input,
                                                 bool keep_angles);

}  // namespace gonio::cli
