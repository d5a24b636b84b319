// The objectives that a fit can minimise, by name.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gonio::fit {

// With cos the cosine of incidence and m what was measured, the weighted sum of:
enum class Objective : std::uint8_t {
  l1,     // |f - m| cos
  l2,     // the square of that difference
  huber,  // Huber's function of that difference
  log,    // |log(1 + f cos) - log(1 + m cos)|
  cbrt,   // the squared difference of the cube roots of f cos and m cos
};
inline constexpr int kObjectiveCount = 5;
inline constexpr std::array<std::string_view, kObjectiveCount> kObjectiveNames{"l1", "l2", "huber",
                                                                               "log", "cbrt"};

constexpr std::string_view name_of(Objective objective) {
  return kObjectiveNames.at(static_cast<std::size_t>(objective));
}

}  // namespace gonio::fit
