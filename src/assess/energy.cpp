#include "assess/energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assess/places.h"

namespace gonio::assess {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array<double, 9> kThetas{0, 15, 30, 45, 60, 75, 85, 89, 89.9};
constexpr std::size_t kRegular = 1 << 17;  // of a regular sequence, for the lost mass
constexpr double kTableCell =
    1. / 1024;  // the largest share of a table's mass in a cell of the subdivision
constexpr double kBins = 96;
constexpr double kCap = 16;  // times the albedo: larger weights count as this

// A quarter of a turn, which changes no bit of a component.
std::vector<Pair> turned(std::vector<Pair> pairs) {
  for (Pair& pair : pairs) {
    for (auto* w : {&pair.wi, &pair.wo}) *w = {-(*w)[1], (*w)[0], (*w)[2]};
  }
  return pairs;
}

bool is_isotropic(const Subject& subject, std::uint64_t seed) {
  const auto pairs = pairs_at(0, subject, 256, seed);
  const auto f = subject.evaluate(pairs, Precision::reference),
             g = subject.evaluate(turned(pairs), Precision::reference);
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (!(std::abs(f[i] - g[i]) <= 1e-6 * std::max(f[i], g[i]))) return false;
  }
  return true;
}

// Columns for each direction: the pdf, and f cos(theta_o) of every channel.
std::vector<double> columns_of(const Subject& subject, const Direction& wi,
                               const std::vector<double>& wo) {
  std::vector<Pair> pairs;
  pairs.reserve(wo.size() / 3);
  for (std::size_t i = 0; i < wo.size(); i += 3)
    pairs.push_back({wi, {wo[i], wo[i + 1], wo[i + 2]}});
  const auto channels = static_cast<std::size_t>(subject.channels);
  const auto [f, pdf] = subject.densities(pairs);
  std::vector<double> columns;
  columns.reserve(pairs.size() * (1 + channels));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    columns.push_back(pdf[i]);
    for (std::size_t c = 0; c < channels; ++c)
      columns.push_back(f[i * channels + c] * pairs[i].wo[2]);
  }
  return columns;
}

// The share of samples below the horizon, estimated with a regular sequence if there are any.
double lost_mass(const Subject& subject, const Direction& wi) {
  const auto lost = [&](std::size_t count, Sequence sequence) {
    const Drawn drawn = subject.draw(wi, count, {sequence, 1}, Precision::reference);
    return static_cast<double>(drawn.lost) / static_cast<double>(count);
  };
  return lost(kRegular / 4, Sequence::random) > 0 ? lost(kRegular, Sequence::sobol) : 0;
}

// Integrands for each direction: of every channel the weight, limited to its cap, times the pdf;
// then the squares of these weights times the pdf.
std::vector<double> capped_columns(const Subject& subject, const Direction& wi,
                                   const std::vector<double>& cap, const std::vector<double>& wo) {
  const std::size_t channels = cap.size(), given = 1 + channels;
  const std::vector<double> columns = columns_of(subject, wi, wo);
  std::vector<double> capped;
  capped.reserve(wo.size() / 3 * 2 * channels);
  for (std::size_t at = 0; at < columns.size(); at += given) {
    const double pdf = columns[at];
    const auto weight = [&](std::size_t c) {
      return pdf > 0 ? std::min(columns[at + 1 + c] / pdf, cap[c]) : 0;
    };
    for (std::size_t c = 0; c < channels; ++c) capped.push_back(weight(c) * pdf);
    for (std::size_t c = 0; c < channels; ++c) capped.push_back(weight(c) * weight(c) * pdf);
  }
  return capped;
}

void add_capped(const Subject& subject, Energy& energy) {
  const std::size_t channels = energy.albedo.size();
  for (const double albedo : energy.albedo) energy.cap.push_back(kCap * albedo);
  const auto found = energy.subdivision.integrals(2 * channels, [&](const std::vector<double>& wo) {
    return capped_columns(subject, energy.given, energy.cap, wo);
  });
  energy.capped.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(channels));
  for (std::size_t c = 0; c < channels; ++c) {
    const double mean = energy.capped[c];
    energy.variance.push_back(std::max(0.0, found[channels + c] - mean * mean));
  }
}

}  // namespace

std::vector<Angles> incidences_of(const Subject& subject, std::uint64_t seed) {
  std::vector<Angles> all;
  const bool isotropic = is_isotropic(subject, seed);
  const double phi = isotropic ? 0 : subject.tangents;
  for (const double theta : kThetas) {
    all.push_back({theta * kDegree, phi});
    if (!isotropic && theta > 0) all.push_back({theta * kDegree, phi + 90 * kDegree});
  }
  return all;
}

Energy integrate_from(const Angles& angles, const Subject& subject,
                      const std::function<bool()>& stop) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  // In float32, so that both precisions get the same direction; each normalises it.
  const double sine = std::sin(angles.theta);
  const Direction given =
      rounded({{{sine * std::cos(angles.phi), sine * std::sin(angles.phi), std::cos(angles.theta)},
                {}}})[0]
          .wi;
  const double length = std::hypot(given[0], given[1], given[2]);
  const Direction unit{given[0] / length, given[1] / length, given[2] / length};
  const auto columns = [&](const std::vector<double>& wo) {
    if (stop && stop()) return std::vector<double>(wo.size() / 3 * (1 + channels));
    return columns_of(subject, given, wo);
  };
  Energy energy{angles, given,
                Subdivision(unit, 1 + channels, columns, subject.tangents,
                            subject.table ? kTableCell : 1. / 64)};
  energy.bins = energy.subdivision.bins(1 / kBins);
  energy.mass = energy.subdivision.integral(0);
  for (std::size_t c = 0; c <= channels; ++c)
    energy.unsure = std::max(energy.unsure, energy.subdivision.change(c));
  for (std::size_t c = 0; c < channels; ++c) {
    energy.albedo.push_back(energy.subdivision.integral(1 + c));
    energy.change.push_back(energy.subdivision.change(1 + c));
  }
  if (stop && stop()) return energy;
  energy.lost = lost_mass(subject, given);
  add_capped(subject, energy);
  return energy;
}

}  // namespace gonio::assess
