// Substances by name, in the place of a colour's numbers: reflectances at normal incidence, and the
// complex indices eta + i k of conductors. All are linear red, green and blue, seen from air.
//
// A conductor's three channels are its values at the tabulated wavelengths nearest to 650, 550 and
// 450 nm, not averages over a colour space's primaries: what the publications print, unchanged.
#pragma once

#include <array>
#include <string_view>

#include "gonio/models/description.h"

namespace gonio::presets {

inline constexpr std::string_view kRendering =
    "Akenine-Moller, Haines & Hoffman 2008, Real-Time Rendering, 3rd edition";
inline constexpr std::string_view kNobleMetals =
    "Johnson & Christy 1972, at 659.5, 548.6 and 450.9 nm";
inline constexpr std::string_view kTransitionMetals =
    "Johnson & Christy 1974, at 659, 549 and 451 nm";
inline constexpr std::string_view kRakic = "Rakic 1995, at 652, 564 and 443 nm";

inline constexpr std::array kReflectance{
    Preset{"water", {0.02, 0.02, 0.02}, kRendering},
    Preset{"plastic", {0.05, 0.05, 0.05}, kRendering},
    Preset{"glass",
           {0.08, 0.08, 0.08},
           "Akenine-Moller, Haines & Hoffman 2008, Real-Time Rendering, 3rd edition; 0.08 implies "
           "eta = 1.79, common glass, eta = 1.5, gives 0.04"},
    Preset{"diamond", {0.17, 0.17, 0.17}, kRendering},
    Preset{"copper", {0.95, 0.64, 0.54}, kRendering},
    Preset{"aluminium", {0.91, 0.92, 0.92}, kRendering}};

struct Conductor {
  std::string_view name;
  std::array<double, 3> eta, k;
  std::string_view source;
};
inline constexpr std::array kConductors{
    Conductor{"gold", {0.14, 0.43, 1.38}, {3.697, 2.455, 1.914}, kNobleMetals},
    Conductor{"silver", {0.05, 0.06, 0.04}, {4.483, 3.586, 2.657}, kNobleMetals},
    Conductor{"copper", {0.22, 1.02, 1.24}, {3.747, 2.577, 2.397}, kNobleMetals},
    Conductor{"aluminium", {1.5724, 1.0728, 0.6079}, {7.7354, 6.7839, 5.3676}, kRakic},
    Conductor{"chromium", {3.09, 3.18, 2.33}, {3.34, 3.33, 3.14}, kTransitionMetals},
    Conductor{"iron", {2.92, 2.95, 2.59}, {3.10, 2.93, 2.77}, kTransitionMetals},
    Conductor{"nickel", {1.99, 1.92, 1.73}, {4.26, 3.61, 2.95}, kTransitionMetals}};

// One part of the complex index of all conductors.
constexpr auto part_of_conductors(std::array<double, 3> Conductor::*part) {
  std::array<Preset, kConductors.size()> presets;
  for (std::size_t i = 0; i < presets.size(); ++i)
    presets[i] = {kConductors[i].name, kConductors[i].*part, kConductors[i].source};
  return presets;
}
inline constexpr auto kIndex = part_of_conductors(&Conductor::eta);
inline constexpr auto kExtinction = part_of_conductors(&Conductor::k);

}  // namespace gonio::presets
