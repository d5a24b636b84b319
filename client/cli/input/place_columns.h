// The columns by which files name directions: xyz or angles. Thread safety: constants.
#pragma once

#include <array>
#include <string_view>

namespace gonio::cli {

// The first half of each is that of wi.
inline constexpr std::array<std::string_view, 6> kDirectionColumns{"wi_x", "wi_y", "wi_z",
                                                                   "wo_x", "wo_y", "wo_z"};
inline constexpr std::array<std::string_view, 4> kAngleColumns{"theta_i", "phi_i", "theta_o",
                                                               "phi_o"};
// The header's set of columns that holds angles, where directions are the first.
inline constexpr std::size_t kAngleSet = 1;

}  // namespace gonio::cli
