// The sampler of a measured table: its density against what it draws, with cells that nobody has
// measured and without.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assess/chi_square.h"
#include "gonio/engine/sampler.h"
#include "gonio/measured/table.h"
#include "measured/synthetic_merl.h"

namespace gonio::testing {
namespace {

using assess::chi_square_probability;
using assess::sidak;
using Vector = std::array<double, 3>;

// A glossy lobe on a diffuse base. `holes` leaves out a part of the table.
Sampler glossy(bool holes) {
  const auto table = MeasuredTable::from_values(tabulate([=](double h, double d, double) -> Rgb {
    const double lobe = 0.3 * std::exp(-std::pow(std::tan(h) / 0.3, 2));
    const bool missing = holes && h > 0.5 && h < 0.6 && d < 0.5;
    return missing ? Rgb{-1, -1, -1} : Rgb{0.1 + lobe, 0.05 + lobe, 0.02 + lobe};
  }));
  return Sampler::create(Material::from_table(*table, Interpolation::linear));
}

Vector incidence(double degrees) {
  const double theta = degrees * std::numbers::pi / 180;
  return {std::sin(theta), 0, std::cos(theta)};
}

// A regular grid over the hemisphere, even in cos(theta_o), in blocks of many points.
constexpr std::size_t kRings = 16, kSectors = 24, kAcross = 40;
constexpr std::size_t kRows = kRings * kAcross, kColumns = kSectors * kAcross;
constexpr double kSolidAngle = 2 * std::numbers::pi / (kRows * kColumns);

std::size_t block_of(const double* wo) {
  const double turn = std::atan2(wo[1], wo[0]) / (2 * std::numbers::pi) + 0.5;
  const auto ring = std::min(static_cast<std::size_t>(wo[2] * kRings), kRings - 1);
  const auto sector = std::min(static_cast<std::size_t>(turn * kSectors), kSectors - 1);
  return ring * kSectors + sector;
}

struct Integrals {
  std::vector<double> masses;  // of the blocks
  double total = 0, albedo = 0, second_moment = 0;
};

Integrals integrate(const Sampler& sampler, const Vector& wi) {
  std::vector<double> wo, pdf(kColumns), f(3 * kColumns);
  Directions<double> given = Directions<double>::interleaved(wi.data());
  given.stride = 0;
  Integrals all{std::vector<double>(kRings * kSectors)};
  for (std::size_t row = 0; row < kRows; ++row) {
    const double z = (static_cast<double>(row) + 0.5) / kRows, sine = std::sqrt(1 - z * z);
    wo.clear();
    for (std::size_t i = 0; i < kColumns; ++i) {
      const double phi = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / kColumns;
      wo.insert(wo.end(), {sine * std::cos(phi), sine * std::sin(phi), z});
    }
    evaluate(sampler,
             Batch<double, double>{given, Directions<double>::interleaved(wo.data()), kColumns,
                                   Values<double>::interleaved(f.data(), 3), nullptr},
             pdf.data(), best_isa());
    for (std::size_t i = 0; i < kColumns; ++i) {
      const double value = f[3 * i] * z;
      all.masses[block_of(&wo[3 * i])] += pdf[i] * kSolidAngle;
      all.total += pdf[i] * kSolidAngle;
      all.albedo += value * kSolidAngle;
      if (pdf[i] > 0) all.second_moment += value * value / pdf[i] * kSolidAngle;
    }
  }
  return all;
}

constexpr std::size_t kDrawn = 1 << 16;

template <class T>
struct Drawn {
  std::vector<T> wo = std::vector<T>(3 * kDrawn), pdf = std::vector<T>(kDrawn);
  std::vector<T> weights = std::vector<T>(3 * kDrawn);
  std::vector<std::uint8_t> flags = std::vector<std::uint8_t>(kDrawn);
  SampleReport report;
};

template <class T>
Drawn<T> draw(const Sampler& sampler, const Vector& wi) {
  const std::array<T, 3> given{static_cast<T>(wi[0]), static_cast<T>(wi[1]), static_cast<T>(wi[2])};
  Drawn<T> drawn;
  SampleBatch<T> batch;
  batch.wi = Directions<T>::interleaved(given.data());
  batch.count = batch.per_wi = kDrawn;
  batch.numbers = {Sequence::random, 17};
  batch.wo = drawn.wo.data();
  batch.pdf = drawn.pdf.data();
  batch.weights = Values<T>::interleaved(drawn.weights.data(), 3);
  batch.flags = drawn.flags.data();
  drawn.report = sample(sampler, batch, best_isa());
  return drawn;
}

struct Place {
  std::string name;
  double theta;
  bool holes;
};

class MeasuredSampler : public ::testing::TestWithParam<Place> {
 protected:
  const Sampler sampler_ = glossy(GetParam().holes);
  const Vector wi_ = incidence(GetParam().theta);
};

TEST_P(MeasuredSampler, DrawsByItsDensity) {
  const Integrals all = integrate(sampler_, wi_);
  const Drawn<double> drawn = draw<double>(sampler_, wi_);
  const double lost = static_cast<double>(drawn.report.lost) / kDrawn;
  // The cells' edges lie across the grid; and four deviations of what is lost.
  EXPECT_NEAR(all.total + lost, 1, 1e-3 + 4 * std::sqrt(lost / kDrawn));

  std::vector<double> expected, observed(all.masses.size());
  for (const double mass : all.masses) expected.push_back(mass * kDrawn);
  double sum = 0;
  for (std::size_t i = 0; i < kDrawn; ++i) {
    sum += drawn.weights[3 * i];
    if (drawn.flags[i] == 0) observed[block_of(&drawn.wo[3 * i])] += 1;
  }
  EXPECT_GT(chi_square_probability(expected, observed), sidak(0.01, 8));
  const double variance = all.second_moment - all.albedo * all.albedo;
  EXPECT_NEAR(sum / kDrawn, all.albedo, 4 * std::sqrt(variance / kDrawn) + 1e-3 * all.albedo);
}

TEST_P(MeasuredSampler, EvaluationGivesTheSamplesDensitiesAndValues) {
  const Drawn<float> drawn = draw<float>(sampler_, wi_);
  const std::array<float, 3> wi{static_cast<float>(wi_[0]), 0, static_cast<float>(wi_[2])};
  Directions<float> given = Directions<float>::interleaved(wi.data());
  given.stride = 0;
  std::vector<float> f(3 * kDrawn), pdf(kDrawn);
  std::vector<std::uint8_t> flags(kDrawn);
  evaluate(sampler_,
           Batch<float, float>{given, Directions<float>::interleaved(drawn.wo.data()), kDrawn,
                               Values<float>::interleaved(f.data(), 3), flags.data()},
           pdf.data(), best_isa());
  std::size_t unknown = 0, lost = 0;
  for (std::size_t i = 0; i < kDrawn; ++i) {
    ASSERT_EQ(pdf[i], drawn.pdf[i]);
    flags[i] = static_cast<std::uint8_t>(flags[i] & ~flag::hole);  // of evaluated pairs only
    ASSERT_EQ(flags[i], drawn.flags[i]);
    unknown += flags[i] == flag::outside_data ? 1 : 0;
    lost += flags[i] != 0 ? 1 : 0;
    const double value = static_cast<double>(f[3 * i]) * static_cast<double>(drawn.wo[3 * i + 2]);
    ASSERT_NEAR(static_cast<double>(drawn.weights[3 * i]) * static_cast<double>(pdf[i]), value,
                1e-6 * value);
  }
  EXPECT_EQ(drawn.report.lost, lost);
  EXPECT_EQ((drawn.report.any_flags & flag::outside_data) != 0, unknown > 0);
  EXPECT_EQ(unknown > 0, GetParam().holes);
}

INSTANTIATE_TEST_SUITE_P(At, MeasuredSampler,
                         ::testing::Values(Place{"normal", 0, false}, Place{"at_30", 30, false},
                                           Place{"at_60", 60, false}, Place{"at_80", 80, false},
                                           Place{"at_89", 89, false}, Place{"at_89_9", 89.9, false},
                                           Place{"at_30_with_holes", 30, true},
                                           Place{"at_60_with_holes", 60, true}),
                         [](const auto& place) { return place.param.name; });

}  // namespace
}  // namespace gonio::testing
