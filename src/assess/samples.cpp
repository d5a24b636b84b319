#include "assess/samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "assess/chi_square.h"

namespace gonio::assess {
namespace {

constexpr std::size_t kDrawn = 1 << 15;    // samples that are compared with the pdf
constexpr std::size_t kWeighed = 1 << 10;  // of these, every weight is checked
constexpr std::size_t kHeaviest = 1 << 6;  // and so many of the largest weights of all

// The probability of what was drawn, by chi-square over bins of the integrated pdf.
double probability_of(const Subject& subject, const Energy& energy, std::uint64_t seed) {
  const Drawn drawn =
      subject.draw(energy.given, kDrawn, {Sequence::random, seed}, Precision::reference);
  std::vector<double> observed(energy.bins.size()), expected;
  for (std::size_t i = 0; i < kDrawn; ++i) {
    const Direction wo{drawn.wo[3 * i], drawn.wo[3 * i + 1], drawn.wo[3 * i + 2]};
    if (drawn.flags[i] == 0) ++observed[energy.subdivision.bin_of(wo)];
  }
  // The total is checked by "pdf_mass".
  const double scale = energy.mass > 0 ? (1 - energy.lost) / energy.mass : 1;
  for (const Bin& bin : energy.bins) expected.push_back(scale * bin.mass * kDrawn);
  expected.push_back(energy.lost * kDrawn);
  observed.push_back(static_cast<double>(drawn.lost));
  return chi_square_probability(expected, observed);
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
    // A product below float32's normal numbers has few digits.
    if (!(size > 1e-30L) || !(wo[2] > 1.001 * subject.fast.cosine)) continue;
    const auto error = static_cast<double>(std::abs(product - f[c] * cosine) / size);
    // NaN counts as the worst.
    if (!std::isnan(worst.error) && !(error <= worst.error))
      worst = {
          error, wi, wo, static_cast<unsigned>(c), product, static_cast<double>(f[c] * cosine)};
  }
}

// The numbers of the samples with the largest weights.
std::vector<std::size_t> heaviest(const Drawn& drawn, std::size_t channels) {
  const auto weight = [&](std::size_t i) {
    double most = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      const double one = drawn.weights[i * channels + c];
      most = std::isnan(one) ? std::numeric_limits<double>::infinity() : std::max(most, one);
    }
    return most;
  };
  std::vector<std::size_t> all(kDrawn);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::partial_sort(all, all.begin() + kHeaviest, std::ranges::greater(), weight);
  all.resize(kHeaviest);
  return all;
}

// The deviation of a mean of capped weights, by Bernstein's inequality: a mean of kDrawn
// independent numbers up to `cap` deviates by z or more with a probability of at most 2 exp(-z^2 /
// 2). For small deviations z counts standard errors. The uncertainty of the quadrature is
// subtracted first.
double deviation_of(const Energy& energy, std::size_t c, double mean) {
  const double known = energy.change[c] + 1e-6 * energy.albedo[c];
  const double off = std::abs(mean - energy.capped[c]) - known;
  if (off <= 0) return 0;
  return off / std::sqrt((energy.variance[c] + energy.cap[c] * off / 3) / kDrawn);
}

void look_at_weights(const Subject& subject, const Energy& energy, std::uint64_t seed,
                     Incidence& at) {
  const auto channels = static_cast<std::size_t>(subject.channels);
  const Drawn drawn = subject.draw(energy.given, kDrawn, {Sequence::random, seed}, Precision::fast);
  for (std::size_t c = 0; c < channels; ++c) {
    double sum = 0, capped = 0, squares = 0;
    for (std::size_t i = 0; i < kDrawn; ++i) {
      const double weight = drawn.weights[i * channels + c];
      sum += weight, squares += weight * weight;
      // Where nothing is reflected, weights are not capped.
      capped += energy.cap[c] > 0 ? std::min(weight, energy.cap[c]) : weight;
    }
    const double mean = sum / kDrawn;
    at.sampled.push_back(mean);
    at.standard_error.push_back(std::sqrt(std::max(0.0, squares / kDrawn - mean * mean) / kDrawn));
    at.deviation.push_back(deviation_of(energy, c, capped / kDrawn));
  }
  std::vector<std::size_t> looked_at = heaviest(drawn, channels);
  for (std::size_t i = 0; i < kWeighed; ++i) looked_at.push_back(i);
  for (const std::size_t i : looked_at) {
    if (drawn.flags[i] == 0) weigh(subject, energy.given, drawn, i, at.weight);
  }
}

}  // namespace

Incidence sample_from(const Energy& energy, const Subject& subject, std::uint64_t seed) {
  Incidence at;
  at.theta = energy.angles.theta, at.phi = energy.angles.phi;
  at.mass = energy.mass, at.unsure = energy.unsure, at.albedo = energy.albedo;
  at.lost = energy.lost;
  at.probability = probability_of(subject, energy, seed + 1);
  look_at_weights(subject, energy, seed + 2, at);
  return at;
}

}  // namespace gonio::assess
