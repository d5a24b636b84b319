#include "assess/places.h"

#include <algorithm>
#include <array>

#include "assess/place_pairs.h"
#include "assess/random_directions.h"

namespace gonio::assess {
namespace {

struct Entry {
  HardPlace place;
  Pair (*pair)(Random&);  // null: the critical angle, of which a material may have several
  bool above = true;      // both directions are above the horizon
};

bool is_above(const Pair& pair) { return pair.wi[2] > 0 && pair.wo[2] > 0; }

constexpr std::array kEntries{
    Entry{{"hemisphere", "both directions anywhere", "loses digits in the half-vector"},
          &at::hemisphere},
    Entry{{"lobe", "h at 1e-6 to 1 rad from n",
           "float32 directions are not exactly unit: a sharp lobe is off by percents"},
          &at::lobe},
    Entry{{"exact_mirror", "h = n", "0/0 in an anisotropic exponent"}, &at::exact_mirror},
    Entry{{"near_mirror", "wo at 1e-8 to 1e-2 rad from the mirror direction", "1 - cos cancels"},
          &at::near_mirror},
    Entry{{"across_mirror", "wo at right angles to the mirror direction",
           "a power of a cosine around 0"},
          &at::across_mirror},
    Entry{{"retro", "wo at 1e-6 to 0.1 rad from wi", "1 - h.k cancels in Fresnel's term"},
          &at::retro},
    Entry{{"same", "wo = wi", "h.k above 1 by rounding"}, &at::same},
    Entry{{"grazing", "one or both at 80 to 89.9999 degrees",
           "1 - (1 - cos/2)^5 cancels; masking over cosines is 0/0"},
          &at::grazing},
    Entry{{"grazing_lobe", "the lobe, with light at 80 to 89.9999 degrees",
           "both at once: a small half-vector's direction, and small divisors"},
          &at::grazing_lobe},
    Entry{{"flat_half_vector", "h all but in the surface", "exp(-tan^2) over cos^4 is 0/0"},
          &at::flat_half_vector},
    Entry{{"opposite", "wo all but -wi, both above the horizon", "h of next to nothing"},
          &at::opposite},
    Entry{{"exactly_opposite", "wo = -wi", "h is NaN"}, &at::exactly_opposite, false},
    Entry{{"horizon", "a cosine of 1e-44 to 1e-6 (proper values only are asked for)",
           "overflows, 0/0"},
          &at::horizon},
    Entry{{"below_horizon", "one or both at or below the horizon (f = 0)", "light from below"},
          &at::below_horizon,
          false},
    Entry{{"axes", "the normal, the tangents' planes", "azimuths of nothing"}, &at::axes},
    Entry{{"equal_angles", "theta_i = theta_o, azimuths of a multiple of 45 degrees apart",
           "the switches of minima and maxima"},
          &at::equal_angles},
    Entry{{"off_unit", "lengths of 1 +- 1e-3", "an error in the length is one in the lobe"},
          &at::off_unit},
    Entry{{"critical_angle", "1e-8 to 0.1 from total reflection (eta < 1)",
           "the root of a negative number"},
          nullptr}};

}  // namespace

std::span<const HardPlace> places() {
  static const auto all = [] {
    std::array<HardPlace, kEntries.size()> places;
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
    return entry.pair != nullptr
               ? entry.pair(random)
               : at::critical_angle(random, subject.rarer[i % subject.rarer.size()]);
  };
  std::vector<Pair> pairs;
  pairs.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Pair pair = draw(i);
    // Directions in the lobe's other half are not at the place.
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
