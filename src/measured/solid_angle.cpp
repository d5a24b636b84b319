#include "measured/solid_angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "numeric/direction.h"

namespace gonio {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kRings = 180;  // from the normal to the horizon, half a degree each
constexpr double kFewestRings = 30;
constexpr double kFineGroups = 200;         // as many grids of half a degree take a second or two
constexpr double kReach = 0.2610523844401;  // the chord of 15 degrees
constexpr std::size_t kLeastWo = 8;

bool is_above(const Direction& w) {
  return std::isfinite(w[0]) && std::isfinite(w[1]) && std::isfinite(w[2]) && w[2] > 0;
}

double square(double x) { return x * x; }

// Finds the nearest of some directions: only those whose height differs by less than the best
// distance so far are looked at.
class Nearest {
 public:
  explicit Nearest(std::span<const double> all) {
    for (std::size_t i = 0; i < all.size() / 3; ++i) {
      if (is_above(nth_direction(all, i))) sorted_.push_back({nth_direction(all, i), i});
    }
    std::sort(sorted_.begin(), sorted_.end(),
              [](const Place& a, const Place& b) { return a.at[2] < b.at[2]; });
  }

  // Its index; -1 if none is within reach.
  [[nodiscard]] std::ptrdiff_t to(const Direction& w) const {
    const auto above = std::lower_bound(sorted_.begin(), sorted_.end(), w[2],
                                        [](const Place& p, double z) { return p.at[2] < z; });
    double best = square(kReach);
    std::ptrdiff_t index = -1;
    const auto look = [&](const Place& p) {
      if (square(p.at[2] - w[2]) >= best) return false;
      const double distance =
          square(p.at[0] - w[0]) + square(p.at[1] - w[1]) + square(p.at[2] - w[2]);
      if (distance < best) {
        best = distance;
        index = static_cast<std::ptrdiff_t>(p.index);
      }
      return true;
    };
    for (auto p = above; p != sorted_.end() && look(*p); ++p) {
    }
    for (auto p = above; p != sorted_.begin() && look(*std::prev(p)); --p) {
    }
    return index;
  }

 private:
  struct Place {
    Direction at;
    std::size_t index;
  };
  std::vector<Place> sorted_;
};

// All measurements of one wi.
struct Group {
  Direction wi{};
  std::vector<std::size_t> members;
};

std::vector<Group> groups_of(std::span<const double> wi) {
  constexpr double kSame = 1e5;  // 1 / the difference that is none
  std::map<std::array<long, 3>, Group> groups;
  for (std::size_t i = 0; i < wi.size() / 3; ++i) {
    const Direction w = nth_direction(wi, i);
    if (!is_above(w) || w[0] * w[0] + w[1] * w[1] + w[2] * w[2] > 2) continue;
    Group& group =
        groups[{std::lround(w[0] * kSame), std::lround(w[1] * kSame), std::lround(w[2] * kSame)}];
    group.wi = w;
    group.members.push_back(i);
  }
  std::vector<Group> list;
  for (auto& [key, group] : groups) list.push_back(std::move(group));
  return list;
}

// The zones, all around the normal, between the angles half way to the next.
std::vector<double> zones(const std::vector<Group>& groups) {
  std::map<double, double> at;  // by angle
  for (const Group& group : groups)
    at[std::atan2(std::hypot(group.wi[0], group.wi[1]), group.wi[2])] = 0;
  if (at.size() == 1) return {2 * kPi};
  for (auto zone = at.begin(); zone != at.end(); ++zone) {
    const bool first = zone == at.begin(), last = std::next(zone) == at.end();
    const double below = first ? 0 : (std::prev(zone)->first + zone->first) / 2;
    const double above = last ? kPi / 2 : (std::next(zone)->first + zone->first) / 2;
    zone->second = 2 * kPi * (std::cos(below) - std::cos(above));
  }
  std::vector<double> measures;
  for (const Group& group : groups)
    measures.push_back(at[std::atan2(std::hypot(group.wi[0], group.wi[1]), group.wi[2])]);
  return measures;
}

std::vector<double> incident_measures(const std::vector<Group>& groups) {
  const Direction& first = groups.front().wi;
  const bool one_plane = std::all_of(groups.begin(), groups.end(), [&](const Group& g) {
    return std::abs(first[0] * g.wi[1] - first[1] * g.wi[0]) < 1e-5;
  });
  if (one_plane) return zones(groups);
  std::vector<double> all;
  for (const Group& group : groups) all.insert(all.end(), group.wi.begin(), group.wi.end());
  return solid_angles(all);
}

// solid_angles() on a grid of that many rings.
std::vector<double> angles_on(int rings, std::span<const double> directions) {
  const Nearest nearest(directions);
  const double width = kPi / 2 / rings;
  std::vector<double> angles(directions.size() / 3, 0);
  // Where measurements are closer than the grid, each still stands for something.
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (is_above(nth_direction(directions, i))) angles[i] = width * width / 4;
  }
  for (int ring = 0; ring < rings; ++ring) {
    const double theta = (ring + 0.5) * width, z = std::cos(theta), s = std::sin(theta);
    const int turns = std::max(6, static_cast<int>(4 * rings * s));
    const double cell = 2 * kPi / turns * (std::cos(ring * width) - std::cos((ring + 1) * width));
    for (int turn = 0; turn < turns; ++turn) {
      const double phi = 2 * kPi * (turn + 0.5) / turns;
      const auto index = nearest.to({s * std::cos(phi), s * std::sin(phi), z});
      if (index >= 0) angles[static_cast<std::size_t>(index)] += cell;
    }
  }
  return angles;
}

// A grid's directions are 2.5 times the square of its rings.
int rings_for(const std::vector<Group>& groups) {
  constexpr double kPerWo = 8;  // directions of the grid, in the densest group
  std::size_t most = 0;
  for (const Group& group : groups) most = std::max(most, group.members.size());
  const double part = std::sqrt(kFineGroups / static_cast<double>(groups.size()));
  const double least = std::sqrt(kPerWo * static_cast<double>(most) / 2.5);
  return static_cast<int>(std::clamp(std::max(kRings * part, least), kFewestRings, double{kRings}));
}

}  // namespace

std::vector<double> solid_angles(std::span<const double> directions) {
  return angles_on(kRings, directions);
}

std::vector<double> pair_measures(std::span<const double> wi, std::span<const double> wo) {
  const std::vector<Group> groups = groups_of(wi);
  const std::size_t pairs = wi.size() / 3;
  if (groups.empty() || groups.size() * kLeastWo > pairs || wo.size() != wi.size()) return {};
  const std::vector<double> incident = incident_measures(groups);
  const int rings = rings_for(groups);
  std::vector<double> measures(pairs, 0);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::vector<double> outgoing;
    for (const std::size_t i : groups[g].members)
      outgoing.insert(outgoing.end(), {wo[3 * i], wo[3 * i + 1], wo[3 * i + 2]});
    const std::vector<double> angles = angles_on(rings, outgoing);
    for (std::size_t k = 0; k < angles.size(); ++k)
      measures[groups[g].members[k]] = incident[g] * angles[k];
  }
  return measures;
}

}  // namespace gonio
