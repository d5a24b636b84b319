// Reflectance in the plane of incidence, measured and of materials: measurements as dots, materials
// as lines, a panel for each angle of incidence and channel. Thread safety: no state.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "client/picture/lobe/canvas.h"
#include "gonio/base/result.h"

namespace gonio::lobe {

// Angles in degrees, theta_o from -90 to 90: negative on the side of the light. Values in 1/sr.
struct SlicePanel {
  double theta_i = 0;
  std::string channel;                     // "red"; empty if there is only one
  std::vector<Spot> measured;              // theta_o and the value
  std::vector<double> theta_o;             // of the lines
  std::vector<std::vector<double>> lines;  // one a material
};

struct SlicesPicture {
  int width = 0, height = 0;
  std::string title;
  std::vector<std::string> materials;  // what the lines are called, up to kMostLines
  std::size_t columns = 1;             // of panels: those of a column have one scale
};

inline constexpr std::size_t kMostLines = 12;

// Three bytes a pixel (sRGB), row by row. `panels` row by row. Errors: what cairo says.
Result<std::vector<std::uint8_t>> draw_slices(const SlicesPicture& picture,
                                              const std::vector<SlicePanel>& panels);

}  // namespace gonio::lobe
