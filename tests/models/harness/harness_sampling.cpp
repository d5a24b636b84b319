#include "models/harness/harness_sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <regex>

#include "models/harness/findings.h"
#include "models/harness/hemisphere.h"

namespace gonio::testing {
namespace {

constexpr std::size_t kDrawn = 1 << 15;
constexpr std::size_t kBins = 96;

// The part of a regular grid of numbers (Hammersley's) that falls below the horizon.
double lost_mass(const SamplingSubject<double>& subject, const Place& place) {
  constexpr std::size_t kPoints = 1 << 17;
  std::vector<double> xi;
  xi.reserve(3 * kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    double mirrored = 0.5 / kPoints;
    for (std::size_t bit = 0; i >> bit != 0; ++bit)
      mirrored += static_cast<double>(i >> bit & 1) * std::ldexp(0.5, -static_cast<int>(bit));
    xi.insert(xi.end(), {std::fmod(static_cast<double>(i) * std::numbers::phi, 1), mirrored,
                         (static_cast<double>(i) + 0.5) / kPoints});
  }
  return static_cast<double>(subject.draw(place.wi, xi).lost) / kPoints;
}

// Whether rounding directions to float32 moves more than a few from bin to bin.
bool blurs_float32(const SamplingSubject<double>& subject, const Place& place,
                   const Subdivision& subdivision) {
  constexpr std::size_t kTried = 2048;
  const Samples<double> samples = subject.draw(place.wi, numbers<double>(place.seed, kTried));
  std::size_t moved = 0;
  for (std::size_t i = 0; i < kTried; ++i) {
    const double* w = &samples.wo[3 * i];
    const auto rounded = [&](std::size_t c) {
      return static_cast<double>(static_cast<float>(w[c]));
    };
    if (samples.flags[i] != 0) continue;
    const Direction exact{w[0], w[1], w[2]}, near{rounded(0), rounded(1), rounded(2)};
    moved += subdivision.bin_of(exact) != subdivision.bin_of(near) ? 1 : 0;
  }
  return moved > kTried / 32;
}

std::string write_densities(const std::string& name, const std::vector<Bin>& bins,
                            const std::vector<double>& observed) {
  const std::string path = ::testing::TempDir() + "densities " +
                           std::regex_replace(name, std::regex("[^A-Za-z0-9_.]+"), "_") + ".csv";
  std::ofstream file(path);
  file << "x,y,z,solid_angle,pdf,sampled\n";
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const auto& [mass, solid_angle, centre] = bins[i];
    file << centre[0] << ',' << centre[1] << ',' << centre[2] << ',' << solid_angle << ','
         << mass / solid_angle << ',' << observed[i] / kDrawn / solid_angle << '\n';
  }
  return path;
}

std::string with_number(const std::string& text, double number) {
  std::ostringstream out;
  out << std::setprecision(8) << text << ' ' << number;
  return out.str();
}

}  // namespace

Integrated integrate(const SamplingSubject<double>& subject, const Place& place) {
  const double length = std::hypot(place.wi[0], place.wi[1], place.wi[2]);
  const Direction unit{place.wi[0] / length, place.wi[1] / length, place.wi[2] / length};
  const std::size_t channels = subject.channels;
  const auto integrands = [&](const std::vector<double>& wo) {
    const auto [pdf, f] = subject.evaluate(place.wi, wo);
    std::vector<double> columns;
    columns.reserve(pdf.size() + 2 * f.size());
    for (std::size_t i = 0; i < pdf.size(); ++i) {
      columns.push_back(pdf[i]);
      for (std::size_t c = 0; c < channels; ++c)
        columns.push_back(f[i * channels + c] * wo[3 * i + 2]);
      for (std::size_t c = 0; c < channels; ++c) {
        const double value = f[i * channels + c] * wo[3 * i + 2];
        columns.push_back(pdf[i] > 0 ? value * (value / pdf[i]) : 0);
      }
    }
    return columns;
  };
  const double tangents = subject.spec.rotation.value_or(0) * std::numbers::pi / 180;
  Integrated all{Subdivision(unit, 1 + 2 * channels, integrands, tangents), {}, 0, false};
  all.bins = all.subdivision.bins(1. / kBins);
  // Most materials lose none; a regular grid is for those that do.
  if (subject.draw(place.wi, numbers<double>(place.seed, kDrawn)).lost > 0)
    all.lost = lost_mass(subject, place);
  all.blurs_float32 = blurs_float32(subject, place, all.subdivision);
  return all;
}

Findings check_total(const Integrated& integrated) {
  Notes notes;
  const Subdivision& s = integrated.subdivision;
  if (!(std::abs(s.solid_angle() / (2 * std::numbers::pi) - 1) < 1e-5))
    notes.add(with_number("the quadrature fails: solid angle", s.solid_angle()));
  if (!(s.change(0) < 1e-3)) notes.add(with_number("the quadrature is unsure by", s.change(0)));
  if (!(std::abs(s.integral(0) + integrated.lost - 1) < 1e-3))
    notes.add(with_number(with_number("integral of the pdf", s.integral(0)) + " and lost mass",
                          integrated.lost));
  return notes.findings();
}

template <class T>
Findings check_distribution(const SamplingSubject<T>& subject, const Place& place,
                            const Integrated& integrated, double level) {
  if (sizeof(T) == sizeof(float) && integrated.blurs_float32) return {};
  const Samples<T> samples = subject.draw(place.wi, numbers<T>(place.seed, kDrawn));
  const std::vector<Bin>& bins = integrated.bins;
  std::vector<double> observed(bins.size()), expected;
  for (std::size_t i = 0; i < kDrawn; ++i) {
    if (samples.flags[i] != 0) continue;
    const auto at = [&](std::size_t c) { return static_cast<double>(samples.wo[3 * i + c]); };
    ++observed[integrated.subdivision.bin_of({at(0), at(1), at(2)})];
  }
  for (const Bin& bin : bins) expected.push_back(bin.mass * kDrawn);
  expected.push_back(integrated.lost * kDrawn);
  observed.push_back(static_cast<double>(samples.lost));
  Notes notes;
  const double probability = chi_square_probability(expected, observed);
  if (!(probability >= level))
    notes.add(with_number("chi-square's probability", probability) + ": see " +
              write_densities(place.name, bins, observed));
  return notes.findings();
}
template Findings check_distribution(const SamplingSubject<float>&, const Place&, const Integrated&,
                                     double);
template Findings check_distribution(const SamplingSubject<double>&, const Place&,
                                     const Integrated&, double);

template <class T>
Findings check_albedo(const SamplingSubject<T>& subject, const Place& place,
                      const Integrated& integrated) {
  const Samples<T> samples = subject.draw(place.wi, numbers<T>(place.seed + 1, kDrawn));
  const Subdivision& s = integrated.subdivision;
  Notes notes;
  for (std::size_t c = 0; c < subject.channels; ++c) {
    double sum = 0;
    for (std::size_t i = 0; i < kDrawn; ++i)
      sum += static_cast<double>(samples.weights[i * subject.channels + c]);
    const double mean = sum / kDrawn, albedo = s.integral(1 + c);
    const double second_moment = s.integral(1 + subject.channels + c);
    const double error = std::sqrt(std::max(0.0, second_moment - albedo * albedo) / kDrawn);
    const double own = s.change(1 + c) + 1e-6 * albedo;
    if (!(std::abs(mean - albedo) <= 4 * error + own))
      notes.add(with_number(with_number(with_number("albedo by sampling", mean) + " +-", error) +
                                ", by quadrature",
                            albedo) +
                with_number(" +-", own) + ", channel " + std::to_string(c));
  }
  return notes.findings();
}
template Findings check_albedo(const SamplingSubject<float>&, const Place&, const Integrated&);
template Findings check_albedo(const SamplingSubject<double>&, const Place&, const Integrated&);

}  // namespace gonio::testing
