#include "assess/energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "assess/chi_square.h"
#include "assess/hemisphere.h"
#include "assess/places.h"

namespace gonio::assess {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array<double, 9> kThetas{0, 15, 30, 45, 60, 75, 85, 89, 89.9};
constexpr std::size_t kDrawn = 1 << 15;    // samples that are held against the pdf
constexpr std::size_t kRegular = 1 << 17;  // of a regular sequence, for the lost mass
constexpr std::size_t kWeighed = 1 << 10;  // of which each weight is looked at
constexpr double kBins = 96;               // of about equal mass

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

// Columns for each direction: the pdf, f cos(theta_o) of every channel, and their squares over the
// pdf, which are the weights' second moments.
std::vector<double> columns_of(const Subject& subject, const Direction& wi,
                               const std::vector<double>& wo) {
  std::vector<Pair> pairs;
  pairs.reserve(wo.size() / 3);
  for (std::size_t i = 0; i < wo.size(); i += 3)
    pairs.push_back({wi, {wo[i], wo[i + 1], wo[i + 2]}});
  const auto channels = static_cast<std::size_t>(subject.channels);
  const auto [f, pdf] = subject.densities(pairs);
  std::vector<double> columns;
  columns.reserve(pairs.size() * (1 + 2 * channels));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    columns.push_back(pdf[i]);
    for (std::size_t c = 0; c < channels; ++c)
      columns.push_back(f[i * channels + c] * pairs[i].wo[2]);
    for (std::size_t c = 0; c < channels; ++c) {
      const double value = f[i * channels + c] * pairs[i].wo[2];
      columns.push_back(pdf[i] > 0 ? value * (value / pdf[i]) : 0);
    }
  }
  return columns;
}

// The probability of what was drawn, by chi-square over bins of the integrated pdf.
double probability_of(const Subject& subject, const Direction& wi, Subdivision& subdivision,
                      double lost, std::uint64_t seed) {
  const Drawn drawn = subject.draw(wi, kDrawn, {Sequence::random, seed}, Precision::reference);
  const std::vector<Bin> bins = subdivision.bins(1 / kBins);
  std::vector<double> observed(bins.size()), expected;
  for (std::size_t i = 0; i < kDrawn; ++i) {
    const Direction wo{drawn.wo[3 * i], drawn.wo[3 * i + 1], drawn.wo[3 * i + 2]};
    if (drawn.flags[i] == 0) ++observed[subdivision.bin_of(wo)];
  }
  for (const Bin& bin : bins) expected.push_back(bin.mass * kDrawn);
  expected.push_back(lost * kDrawn);
  observed.push_back(static_cast<double>(drawn.lost));
  return chi_square_probability(expected, observed);
}

double lost_mass(const Subject& subject, const Direction& wi, std::uint64_t seed) {
  const auto lost = [&](std::size_t count, Sequence sequence) {
    const Drawn drawn = subject.draw(wi, count, {sequence, seed}, Precision::reference);
    return static_cast<double>(drawn.lost) / static_cast<double>(count);
  };
  return lost(kDrawn, Sequence::random) > 0 ? lost(kRegular, Sequence::sobol) : 0;
}

// weight pdf of a sample against f cos(theta_o) of its rounded direction.
void weigh(const Subject& subject, const Direction& wi, const Drawn& drawn, std::size_t sample,
           Worst& worst) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  const Direction wo{drawn.wo[3 * sample], drawn.wo[3 * sample + 1], drawn.wo[3 * sample + 2]};
  std::vector<long double> f(channels), scale(channels);
  subject.truth.evaluate(wi, wo, f, scale);
  const long double cosine =
      wo[2] / std::hypot(static_cast<long double>(wo[0]), static_cast<long double>(wo[1]),
                         static_cast<long double>(wo[2]));
  for (std::size_t c = 0; c < channels; ++c) {
    const long double size = scale[c] * cosine;
    const double product = drawn.weights[sample * channels + c] * drawn.pdf[sample];
    // A product beyond float32's normal numbers has few digits.
    if (!(size > 1e-30L) || !(wo[2] > 1.001 * subject.fast.cosine)) continue;
    const auto error = static_cast<double>(std::abs(product - f[c] * cosine) / size);
    if (!(error <= worst.error))
      worst = {error, {wi, wo}, static_cast<int>(c), product, static_cast<double>(f[c] * cosine)};
  }
}

void look_at_samples(const Subject& subject, const Direction& wi, const Subdivision& subdivision,
                     std::uint64_t seed, Incidence& at) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  const Drawn drawn = subject.draw(wi, kDrawn, {Sequence::random, seed}, Precision::fast);
  for (std::size_t c = 0; c < channels; ++c) {
    double sum = 0;
    for (std::size_t i = 0; i < kDrawn; ++i) sum += drawn.weights[i * channels + c];
    const double albedo = subdivision.integral(1 + c);
    const double squares = subdivision.integral(1 + channels + c) - albedo * albedo;
    at.sampled.push_back(sum / kDrawn);
    at.standard_error.push_back(std::sqrt(std::max(0.0, squares) / kDrawn));
  }
  for (std::size_t i = 0; i < kWeighed; ++i) {
    if (drawn.flags[i] == 0) weigh(subject, wi, drawn, i, at.weight);
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

Incidence look_from(const Angles& angles, const Subject& subject, std::uint64_t seed,
                    const std::function<bool()>& stop) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  // In float32, so that every precision is given the same; its length is put right by each.
  const double sine = std::sin(angles.theta);
  const Pair given =
      rounded({{{sine * std::cos(angles.phi), sine * std::sin(angles.phi), std::cos(angles.theta)},
                {}}})[0];
  const double length = std::hypot(given.wi[0], given.wi[1], given.wi[2]);
  const Direction unit{given.wi[0] / length, given.wi[1] / length, given.wi[2] / length};
  const auto columns = [&](const std::vector<double>& wo) {
    if (stop && stop()) return std::vector<double>(wo.size() / 3 * (1 + 2 * channels));
    return columns_of(subject, given.wi, wo);
  };
  Subdivision subdivision(unit, 1 + 2 * channels, columns, subject.tangents);
  Incidence at;
  at.theta = angles.theta, at.phi = angles.phi;
  at.mass = subdivision.integral(0);
  for (std::size_t c = 0; c <= channels; ++c)
    at.unsure = std::max(at.unsure, subdivision.change(c));
  for (std::size_t c = 0; c < channels; ++c) at.albedo.push_back(subdivision.integral(1 + c));
  at.lost = lost_mass(subject, given.wi, seed);
  at.probability = probability_of(subject, given.wi, subdivision, at.lost, seed + 1);
  look_at_samples(subject, given.wi, subdivision, seed + 2, at);
  return at;
}

}  // namespace gonio::assess
