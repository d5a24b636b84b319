// The --grid argument: axes of angles in one line of text. Thread safety: no state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/client/grid.h"

namespace gonio::cli {

inline constexpr std::uint64_t kMostAngles = 1'000'000;     // of one axis
inline constexpr std::uint64_t kMostPairs = 1'000'000'000;  // of a grid

struct GridSpec {
  client::Grid grid;                       // in radians
  std::vector<std::string> names;          // of the axes, the last the fastest
  std::vector<std::vector<double>> given;  // their angles in the unit in which they were given
};

// "theta_i=0:80:9,theta_o=0/15/40,phi_o=180": each axis START:STOP:COUNT (both ends included) or
// angles separated by '/'. Either of theta_i, phi_i, theta_o, phi_o (one that is not given is 0) or
// of theta_h, theta_d, phi_d. The numbers are degrees or radians. Errors name the axis, the text
// and what is allowed; the size is checked before anything is expanded.
Result<GridSpec> parse_grid(const std::string& text, bool degrees);

}  // namespace gonio::cli
