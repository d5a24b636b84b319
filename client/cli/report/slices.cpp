#include "client/cli/report/slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "client/picture/lobe/lobe.h"
#include "gonio/engine/evaluate.h"
#include "gonio/engine/grid.h"

namespace gonio::cli {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr std::array<double, 3> kWanted = {30, 60, 80};
constexpr double kNearest = 5.01;  // how far a slice may be from what is wanted: 5, and rounding
constexpr double kBeside = 0.5;    // from the slice, in theta_i
constexpr double kOutOfPlane = 2;  // and in azimuth
constexpr double kNoAzimuth = 3;   // closer to the normal an azimuth means nothing

// A pair close to the plane of incidence, in degrees; theta_o is negative on the side of the light.
struct InPlane {
  std::size_t pair;
  double theta_i, phi_i, theta_o;
};

double around(double angle) { return angle - 360 * std::floor(angle / 360 + 0.5); }

std::optional<InPlane> in_plane(const fit::Data& data, std::size_t pair) {
  const auto at = [&](const auto& v) { return std::array{v[0][pair], v[1][pair], v[2][pair]}; };
  const auto wi = at(data.wi), wo = at(data.wo);
  const double theta_i = std::atan2(std::hypot(wi[0], wi[1]), wi[2]) * kDegrees;
  if (theta_i < kNoAzimuth) return std::nullopt;
  const double phi_i = std::atan2(wi[1], wi[0]), c = std::cos(phi_i), s = std::sin(phi_i);
  const double along = -(c * wo[0] + s * wo[1]), across = c * wo[1] - s * wo[0];
  const double theta_o = std::atan2(std::hypot(along, across), wo[2]) * kDegrees;
  const double off = std::abs(std::atan2(std::abs(across), std::abs(along))) * kDegrees;
  if (theta_o > kNoAzimuth && off > kOutOfPlane) return std::nullopt;
  return InPlane{pair, theta_i, phi_i * kDegrees, std::copysign(theta_o, along)};
}

std::vector<InPlane> all_in_plane(const fit::Data& data) {
  std::vector<InPlane> pairs;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (const auto pair = in_plane(data, i)) pairs.push_back(*pair);
  }
  return pairs;
}

// The azimuth at which most of these pairs are, or half a turn from it: a cell of a table at the
// mirror direction may have any azimuth, the others of its slice have not.
double common_azimuth(const std::vector<InPlane>& pairs, double theta_i) {
  constexpr double kBin = 2;
  constexpr std::size_t kBins = 90;
  std::array<std::size_t, kBins> counts{};
  std::array<double, kBins> first{};
  for (const InPlane& pair : pairs) {
    if (std::abs(pair.theta_i - theta_i) > kBeside) continue;
    const double half_turn = pair.phi_i - 180 * std::floor(pair.phi_i / 180);
    const std::size_t bin = static_cast<std::size_t>(std::lround(half_turn / kBin)) % kBins;
    if (counts[bin]++ == 0) first[bin] = pair.phi_i;
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return first[static_cast<std::size_t>(most - counts.begin())];
}

struct Place {
  double theta_i, phi_i;
};

// Where a slice is made: at the angle wanted if it is measured, else at the nearest one.
std::optional<Place> place_near(const std::vector<InPlane>& pairs, double wanted) {
  const auto distance = [&](const InPlane& pair) { return std::abs(pair.theta_i - wanted); };
  const auto nearest = std::min_element(
      pairs.begin(), pairs.end(),
      [&](const InPlane& a, const InPlane& b) { return distance(a) < distance(b); });
  if (nearest == pairs.end() || distance(*nearest) > kNearest) return std::nullopt;
  const double theta_i = distance(*nearest) < kBeside ? wanted : nearest->theta_i;
  return Place{theta_i, common_azimuth(pairs, theta_i)};
}

// A dot keeps its distance from the mirror direction, on which a lobe depends most.
std::vector<lobe::Spot> dots(const fit::Data& data, const std::vector<InPlane>& pairs,
                             const Place& place, int channel) {
  std::vector<lobe::Spot> spots;
  for (const InPlane& pair : pairs) {
    if (std::abs(pair.theta_i - place.theta_i) > kBeside) continue;
    if (std::abs(around(2 * (pair.phi_i - place.phi_i))) > 2 * kOutOfPlane) continue;
    spots.push_back(
        {pair.theta_o - pair.theta_i + place.theta_i, double{data.channel(channel)[pair.pair]}});
  }
  return spots;
}

// [pair][channel]
std::vector<float> values_of(const Material& material, const Place& place,
                             const std::vector<double>& theta_o) {
  constexpr double kRadians = std::numbers::pi / 180;
  std::vector<float> wi, wo;
  std::array<double, 3> direction{};
  for (const double theta : theta_o) {
    direction_at(place.theta_i * kRadians, place.phi_i * kRadians, direction.data());
    wi.insert(wi.end(), {static_cast<float>(direction[0]), static_cast<float>(direction[1]),
                         static_cast<float>(direction[2])});
    direction_at(theta * kRadians, (place.phi_i + 180) * kRadians, direction.data());
    wo.insert(wo.end(), {static_cast<float>(direction[0]), static_cast<float>(direction[1]),
                         static_cast<float>(direction[2])});
  }
  std::vector<float> values(theta_o.size() * static_cast<std::size_t>(material.channels()));
  evaluate(
      material,
      Batch<float, float>{Directions<float>::interleaved(wi.data()),
                          Directions<float>::interleaved(wo.data()), theta_o.size(),
                          Values<float>::interleaved(values.data(), material.channels()), nullptr},
      best_isa());
  return values;
}

std::vector<int> shown_channels(int channels) {
  if (channels == 1) return {0};
  if (channels == 2) return {0, 1};
  if (channels == 3) return {0, 1, 2};
  return {channels / 6, channels / 2, channels - 1 - channels / 6};
}

std::string channel_name(int channel, int channels) {
  constexpr std::array<const char*, 3> kColours = {"red", "green", "blue"};
  if (channels == 1) return {};
  if (channels == 3) return kColours[static_cast<std::size_t>(channel)];
  return "channel " + std::to_string(channel);
}

// What the materials reflect at a place.
struct Lines {
  Place place;
  std::vector<double> theta_o;
  std::vector<std::vector<float>> values;  // of each material
};

lobe::SlicePanel panel_of(const fit::Data& data, const std::vector<InPlane>& pairs,
                          const std::vector<Material>& materials, const Lines& lines, int channel) {
  lobe::SlicePanel panel{lines.place.theta_i,
                         channel_name(channel, data.channels),
                         dots(data, pairs, lines.place, channel),
                         lines.theta_o,
                         {}};
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const auto channels = static_cast<std::size_t>(materials[m].channels());
    const std::size_t c = channels == 1 ? 0 : static_cast<std::size_t>(channel);
    std::vector<double>& line = panel.lines.emplace_back();
    for (std::size_t i = 0; i < lines.theta_o.size(); ++i)
      line.push_back(double{lines.values[m][i * channels + c]});
  }
  return panel;
}

}  // namespace

Result<Slices> slices_of(const fit::Data& data, const std::vector<Material>& materials) {
  const std::vector<InPlane> pairs = all_in_plane(data);
  std::vector<Lines> places;
  for (const double wanted : kWanted) {
    const auto place = place_near(pairs, wanted);
    if (!place) continue;
    Lines& lines = places.emplace_back(Lines{*place, lobe::angles_around(place->theta_i), {}});
    for (const Material& material : materials)
      lines.values.push_back(values_of(material, *place, lines.theta_o));
  }
  if (places.empty()) {
    return bad_value("--slices", "of measurements that have none there",
                     "some in the plane of incidence, within 5 degrees of 30, 60 or 80");
  }
  Slices slices{{}, places.size()};
  for (const int channel : shown_channels(data.channels)) {
    for (const Lines& lines : places)
      slices.panels.push_back(panel_of(data, pairs, materials, lines, channel));
  }
  return slices;
}

}  // namespace gonio::cli
