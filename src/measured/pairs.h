// Measured reflectance as gonioreflectometers give it: scattered pairs of directions in files.
//
// Directions in the local frame of engine/evaluate.h, unit; values in 1/sr, without a cosine. What
// a file holds is not judged here: values below 0 and directions below the horizon are passed on.
// Errors name file, line, what was found and what was expected. Thread safety: functions without
// state.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gonio/base/result.h"

namespace gonio {

// As evaluation has it: nearer to the horizon nothing is known.
inline constexpr double kLeastCosine = 1e-6;

struct MeasuredPairs {
  int channels = 0;
  std::vector<double> wi, wo;  // xyz of each pair
  std::vector<double> values;  // all channels of the first pair, then of the second
  // In sr^2, the measure of pairs of directions that each stands for, where a file says; see
  // solid_angle.h where it does not and this is empty.
  std::vector<double> weights;
  std::size_t raised = 0;  // values below 0 that were set to 0 (read_rgl)

  [[nodiscard]] std::size_t size() const { return wi.size() / 3; }
};

// Cornell's text (as published with pbrt-v2): comments from '#' to the end of the line; the number
// of wavelengths, 1 to 64; the wavelengths in nm, on as many lines as they take; then rows, each on
// a line of its own, of theta_i phi_i theta_s phi_s in radians and a value for each wavelength.
Result<MeasuredPairs> read_cornell(const std::filesystem::path& file);

// ALTA's text with `#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI` and `#DIM 3 N`: lines of theta_i,
// theta_o cos(dphi), theta_o sin(dphi) in radians and N values. With `#PARAM_OUT
// INV_STERADIAN_COSINE_FACTOR` the values hold the cosine of theta_o and are divided by it; entries
// at the horizon then come back with wo.z = 0. ALTA's conventions: core/params.h there.
Result<MeasuredPairs> read_alta(const std::filesystem::path& file);

// A file of the RGL material database (.bsdf) of an isotropic material in RGB: the nodes of its
// grid, without interpolation. Dupuy and Jakob 2018. Those of the mirror direction stand for no
// solid angle and come with a weight of 0. A colour that sRGB cannot show has a channel below 0: it
// is raised to 0 where another channel is above, and counted.
Result<MeasuredPairs> read_rgl(const std::filesystem::path& file);

// The same from the text itself; `name` is what errors call it.
Result<MeasuredPairs> parse_cornell(std::string_view text, const std::string& name);
Result<MeasuredPairs> parse_alta(std::string_view text, const std::string& name);
Result<MeasuredPairs> parse_rgl(std::string_view bytes, const std::string& name);

}  // namespace gonio
