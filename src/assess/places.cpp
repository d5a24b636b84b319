#include "assess/places.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assess/random_directions.h"

namespace gonio::assess {
namespace {

Pair hemisphere(Random& random) { return {random.hemisphere(), random.hemisphere()}; }

Pair lobe(Random& random) {
  return about(random.hemisphere(), spherical(random.logarithmic(1e-6, 1), random.turn()));
}

Pair exact_mirror(Random& random) {
  const Direction wi = random.chance(0.3) ? random.grazing() : random.hemisphere();
  return {wi, mirrored(wi)};
}

Pair near_mirror(Random& random) {
  const Direction wi = random.hemisphere(), at = mirrored(wi);
  const double off = random.logarithmic(1e-8, 1e-2), turn = random.turn();
  return {wi, spherical(std::acos(at[2]) + off * std::cos(turn),
                        std::atan2(at[1], at[0]) + off * std::sin(turn))};
}

Pair across_mirror(Random& random) {
  const Direction wi = random.hemisphere(), at = mirrored(wi), any = random.hemisphere();
  Direction wo{at[1] * any[2] - at[2] * any[1], at[2] * any[0] - at[0] * any[2],
               at[0] * any[1] - at[1] * any[0]};
  const double length = std::copysign(std::hypot(wo[0], wo[1], wo[2]), wo[2]);
  for (double& x : wo) x /= length;
  return {wi, wo};
}

Pair retro(Random& random) {
  const Direction wi = random.chance(0.2) ? random.grazing() : random.hemisphere();
  const double off = random.logarithmic(1e-6, 0.1), turn = random.turn();
  return {wi, spherical(std::acos(wi[2]) + off * std::cos(turn),
                        std::atan2(wi[1], wi[0]) + off * std::sin(turn))};
}

Pair same(Random& random) {
  const Direction wi = random.hemisphere();
  return {wi, wi};
}

Pair grazing(Random& random) {
  const double which = random.uniform(0, 3);
  return {which < 2 ? random.grazing() : random.hemisphere(),
          which < 1 ? random.hemisphere() : random.grazing()};
}

Pair grazing_lobe(Random& random) {
  return about(random.grazing(), spherical(random.logarithmic(1e-6, 1), random.turn()));
}

Pair flat_half_vector(Random& random) {
  const Direction wi = random.grazing();
  const double phi = std::atan2(wi[1], wi[0]) + random.uniform(-1, 1);
  return {wi, elevated(random.logarithmic(1.1e-6, 0.1), phi)};
}

Pair opposite(Random& random) {
  const double phi = random.turn(), off = random.logarithmic(1e-9, 1e-2);
  return {elevated(random.logarithmic(1.1e-6, 1e-2), phi),
          elevated(random.logarithmic(1.1e-6, 1e-2), phi + kPi + off)};
}

Pair exactly_opposite(Random& random) {
  const Direction wi = random.hemisphere();
  return {wi, {-wi[0], -wi[1], -wi[2]}};
}

Pair horizon(Random& random) {
  Direction wi = elevated(0, random.turn());
  wi[2] = random.logarithmic(1e-44, 1e-6);
  Direction wo = random.chance(0.5) ? random.hemisphere() : elevated(0, random.turn());
  if (wo[2] == 0) wo[2] = random.logarithmic(1e-44, 1e-6);
  if (random.chance(0.2)) wo = {-wi[0], -wi[1], wo[2]};
  return random.chance(0.5) ? Pair{wi, wo} : Pair{wo, wi};
}

Pair below_horizon(Random& random) {
  Direction wi = random.hemisphere(), wo = random.hemisphere();
  const double which = random.uniform(0, 3);
  if (which < 2) wi[2] = -wi[2];
  if (which > 1) wo[2] = random.chance(0.2) ? 0 : -wo[2];
  return {wi, wo};
}

// On the axes and next to the normal, where azimuths have no meaning.
Pair axes(Random& random) {
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

Pair equal_angles(Random& random) {
  const double theta = random.uniform(0, 89.9 * kDegree), phi = random.turn();
  const double apart = std::floor(random.uniform(0, 8)) * kPi / 4;
  const double off = random.chance(0.5) ? 0 : random.logarithmic(1e-8, 1e-3);
  return {spherical(theta, phi), spherical(theta, phi + apart + off)};
}

// Anything in the hemisphere, near the lobe and at grazing, as far off unit length as is accepted.
Pair off_unit(Random& random) {
  Pair pair = random.chance(0.5)   ? lobe(random)
              : random.chance(0.5) ? hemisphere(random)
                                   : grazing(random);
  const double i = 1 + random.uniform(-9.9e-4, 9.9e-4), o = 1 + random.uniform(-9.9e-4, 9.9e-4);
  for (double& x : pair.wi) x *= i;
  for (double& x : pair.wo) x *= o;
  return pair;
}

// At the angle from which on a dielectric of index eta < 1 reflects all.
Pair critical_angle(Random& random, double eta) {
  const double critical = std::sqrt(1 - eta * eta), off = random.logarithmic(1e-8, 0.1);
  const double c = std::clamp(critical + (random.chance(0.5) ? off : -off), 0.0, 1.0);
  return around(spherical(random.logarithmic(1e-4, 1), random.turn()), c, random.turn());
}

struct Entry {
  Place place;
  Pair (*pair)(Random&);  // null: the critical angle, of which a material may have several
  bool above = true;      // the horizon, both directions
};

bool is_above(const Pair& pair) { return pair.wi[2] > 0 && pair.wo[2] > 0; }

constexpr std::array kEntries{
    Entry{{"hemisphere", "both directions anywhere", "loses digits in the half-vector"},
          &hemisphere},
    Entry{{"lobe", "h at 1e-6 to 1 rad from n",
           "float32 directions are not exactly unit: a sharp lobe is off by percents"},
          &lobe},
    Entry{{"exact_mirror", "h = n", "0/0 in an anisotropic exponent"}, &exact_mirror},
    Entry{{"near_mirror", "wo at 1e-8 to 1e-2 rad from the mirror direction", "1 - cos cancels"},
          &near_mirror},
    Entry{{"across_mirror", "wo at right angles to the mirror direction",
           "a power of a cosine around 0"},
          &across_mirror},
    Entry{{"retro", "wo at 1e-6 to 0.1 rad from wi", "1 - h.k cancels in Fresnel's term"}, &retro},
    Entry{{"same", "wo = wi", "h.k above 1 by rounding"}, &same},
    Entry{{"grazing", "one or both at 80 to 89.9999 degrees",
           "1 - (1 - cos/2)^5 cancels; masking over cosines is 0/0"},
          &grazing},
    Entry{{"grazing_lobe", "the lobe, with light at 80 to 89.9999 degrees",
           "both at once: a small half-vector's direction, and small divisors"},
          &grazing_lobe},
    Entry{{"flat_half_vector", "h all but in the surface", "exp(-tan^2) over cos^4 is 0/0"},
          &flat_half_vector},
    Entry{{"opposite", "wo all but -wi, both above the horizon", "h of next to nothing"},
          &opposite},
    Entry{{"exactly_opposite", "wo = -wi", "h is NaN"}, &exactly_opposite, false},
    Entry{{"horizon", "a cosine of 1e-44 to 1e-6 (proper values only are asked for)",
           "overflows, 0/0"},
          &horizon},
    Entry{{"below_horizon", "one or both at or below the horizon (f = 0)", "light from below"},
          &below_horizon,
          false},
    Entry{{"axes", "the normal, the tangents' planes", "azimuths of nothing"}, &axes},
    Entry{{"equal_angles", "theta_i = theta_o, azimuths of a multiple of 45 degrees apart",
           "the switches of minima and maxima"},
          &equal_angles},
    Entry{{"off_unit", "lengths of 1 +- 1e-3", "an error in the length is one in the lobe"},
          &off_unit},
    Entry{{"critical_angle", "1e-8 to 0.1 from total reflection (eta < 1)",
           "the root of a negative number"},
          nullptr}};

}  // namespace

std::span<const Place> places() {
  static const auto all = [] {
    std::array<Place, kEntries.size()> places;
    std::ranges::transform(kEntries, places.begin(), &Entry::place);
    return places;
  }();
  return all;
}

std::vector<Pair> pairs_at(std::size_t place, const Subject& subject, std::size_t count,
                           std::uint64_t seed) {
  const Entry& entry = kEntries[place];
  if (entry.pair == nullptr && subject.rarer.empty()) return {};
  Random random(seed * 1'000'003 + place);
  const auto draw = [&](std::size_t i) {
    return entry.pair != nullptr ? entry.pair(random)
                                 : critical_angle(random, subject.rarer[i % subject.rarer.size()]);
  };
  std::vector<Pair> pairs;
  pairs.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Pair pair = draw(i);
    // A lobe's other half would say nothing of the place.
    for (int again = 0; entry.above && again < 64 && !is_above(pair); ++again) pair = draw(i);
    pairs.push_back(pair);
  }
  return pairs;
}

std::vector<Pair> rounded(std::vector<Pair> pairs) {
  for (Pair& pair : pairs) {
    for (auto* w : {&pair.wi, &pair.wo}) {
      for (double& x : *w) x = static_cast<double>(static_cast<float>(x));
    }
  }
  return pairs;
}

}  // namespace gonio::assess
