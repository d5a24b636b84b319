// A random pair of directions for each place of the catalogue. Internal to places.cpp, which
// describes the places. Thread safety: one Random a thread.
#pragma once

#include <algorithm>
#include <cmath>

#include "assess/random_directions.h"

namespace gonio::assess::at {

inline Pair hemisphere(Random& random) { return {random.hemisphere(), random.hemisphere()}; }

inline Pair lobe(Random& random) {
  return about(random.hemisphere(), spherical(random.logarithmic(1e-6, 1), random.turn()));
}

inline Pair exact_mirror(Random& random) {
  const Direction wi = random.chance(0.3) ? random.grazing() : random.hemisphere();
  return {wi, mirrored(wi)};
}

inline Pair near_mirror(Random& random) {
  const Direction wi = random.hemisphere(), at = mirrored(wi);
  const double off = random.logarithmic(1e-8, 1e-2), turn = random.turn();
  return {wi, spherical(std::acos(at[2]) + off * std::cos(turn),
                        std::atan2(at[1], at[0]) + off * std::sin(turn))};
}

inline Pair across_mirror(Random& random) {
  const Direction wi = random.hemisphere(), at = mirrored(wi), any = random.hemisphere();
  Direction wo{at[1] * any[2] - at[2] * any[1], at[2] * any[0] - at[0] * any[2],
               at[0] * any[1] - at[1] * any[0]};
  const double length = std::copysign(std::hypot(wo[0], wo[1], wo[2]), wo[2]);
  for (double& x : wo) x /= length;
  return {wi, wo};
}

inline Pair retro(Random& random) {
  const Direction wi = random.chance(0.2) ? random.grazing() : random.hemisphere();
  const double off = random.logarithmic(1e-6, 0.1), turn = random.turn();
  return {wi, spherical(std::acos(wi[2]) + off * std::cos(turn),
                        std::atan2(wi[1], wi[0]) + off * std::sin(turn))};
}

inline Pair same(Random& random) {
  const Direction wi = random.hemisphere();
  return {wi, wi};
}

inline Pair grazing(Random& random) {
  const double which = random.uniform(0, 3);
  return {which < 2 ? random.grazing() : random.hemisphere(),
          which < 1 ? random.hemisphere() : random.grazing()};
}

inline Pair grazing_lobe(Random& random) {
  return about(random.grazing(), spherical(random.logarithmic(1e-6, 1), random.turn()));
}

inline Pair flat_half_vector(Random& random) {
  const Direction wi = random.grazing();
  const double phi = std::atan2(wi[1], wi[0]) + random.uniform(-1, 1);
  return {wi, elevated(random.logarithmic(1.1e-6, 0.1), phi)};
}

inline Pair opposite(Random& random) {
  const double phi = random.turn(), off = random.logarithmic(1e-9, 1e-2);
  return {elevated(random.logarithmic(1.1e-6, 1e-2), phi),
          elevated(random.logarithmic(1.1e-6, 1e-2), phi + kPi + off)};
}

inline Pair exactly_opposite(Random& random) {
  const Direction wi = random.hemisphere();
  return {wi, {-wi[0], -wi[1], -wi[2]}};
}

inline Pair horizon(Random& random) {
  Direction wi = elevated(0, random.turn());
  wi[2] = random.logarithmic(1e-44, 1e-6);
  Direction wo = random.chance(0.5) ? random.hemisphere() : elevated(0, random.turn());
  if (wo[2] == 0) wo[2] = random.logarithmic(1e-44, 1e-6);
  if (random.chance(0.2)) wo = {-wi[0], -wi[1], wo[2]};
  return random.chance(0.5) ? Pair{wi, wo} : Pair{wo, wi};
}

inline Pair below_horizon(Random& random) {
  Direction wi = random.hemisphere(), wo = random.hemisphere();
  const double which = random.uniform(0, 3);
  if (which < 2) wi[2] = -wi[2];
  if (which > 1) wo[2] = random.chance(0.2) ? 0 : -wo[2];
  return {wi, wo};
}

// On the axes and next to the normal, where azimuths have no meaning.
inline Pair axes(Random& random) {
  const auto one = [&random] {
    const double quarter = std::floor(random.uniform(0, 4));
    const double x = quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
    const double y = quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
    const double theta = random.chance(0.2)   ? 0
                         : random.chance(0.3) ? random.logarithmic(1e-8, 1e-3)
                                              : random.uniform(0, 89.9 * kDegree);
    return Direction{x * std::sin(theta), y * std::sin(theta), std::cos(theta)};
  };
  return {one(), one()};
}

inline Pair equal_angles(Random& random) {
  const double theta = random.uniform(0, 89.9 * kDegree), phi = random.turn();
  const double apart = std::floor(random.uniform(0, 8)) * kPi / 4;
  const double off = random.chance(0.5) ? 0 : random.logarithmic(1e-8, 1e-3);
  return {spherical(theta, phi), spherical(theta, phi + apart + off)};
}

// Anything in the hemisphere, near the lobe and at grazing, as far off unit length as is accepted.
inline Pair off_unit(Random& random) {
  Pair pair = random.chance(0.5)   ? lobe(random)
              : random.chance(0.5) ? hemisphere(random)
                                   : grazing(random);
  const double i = 1 + random.uniform(-9.9e-4, 9.9e-4), o = 1 + random.uniform(-9.9e-4, 9.9e-4);
  for (double& x : pair.wi) x *= i;
  for (double& x : pair.wo) x *= o;
  return pair;
}

// At the critical angle, beyond which a dielectric of index eta < 1 reflects all light.
inline Pair critical_angle(Random& random, double eta) {
  const double critical = std::sqrt(1 - eta * eta), off = random.logarithmic(1e-8, 0.1);
  const double c = std::clamp(critical + (random.chance(0.5) ? off : -off), 0.0, 1.0);
  return around(spherical(random.logarithmic(1e-4, 1), random.turn()), c, random.turn());
}

}  // namespace gonio::assess::at
