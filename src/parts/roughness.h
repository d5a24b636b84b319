// Roughness along both tangents, as the parameters of the anisotropic models.
#pragma once

#include <array>

#include "gonio/models/description.h"

namespace gonio::roughness {

inline constexpr Parameter kAlphaX{.name = "alpha_x",
                                   .meaning = "roughness along the tangent u",
                                   .unit = "1",
                                   .lower = 1e-3,
                                   .upper = 1,
                                   .start = 0.3,
                                   .scale = Scale::logarithmic};
inline constexpr Parameter kAlphaY{.name = "alpha_y",
                                   .meaning = "roughness along the tangent v",
                                   .unit = "1",
                                   .lower = 1e-3,
                                   .upper = 1,
                                   .start = 0.3,
                                   .scale = Scale::logarithmic};

inline constexpr std::array kAlongTangents{kAlphaX.name, kAlphaY.name};

}  // namespace gonio::roughness
