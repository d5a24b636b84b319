// Where methods fail: for each known place a material that shows it, what its formula gives there
// in naive arithmetic, and what the product gives. Run with --gtest_filter='*Stability*' for the
// numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "assess/accuracy.h"
#include "assess/assessed.h"
#include "assess/naive.h"
#include "assess/places.h"

namespace gonio::testing {
namespace {

using assess::Findings;
using assess::Naive;
using assess::PlaceReport;

constexpr double kFast = 3e-6;  // what the product states

PlaceReport report_at(std::string_view place, const MaterialSpec& spec) {
  const auto found = std::ranges::find(assess::places(), place, &assess::HardPlace::name);
  const auto index = static_cast<std::size_t>(found - assess::places().begin());
  auto report = assess::look_at(index, subject_of(material_of(spec)), 20'000, 1, {});
  EXPECT_TRUE(report) << place;
  return *report;
}

std::string text_of(const Findings& f) {
  char text[96];
  std::snprintf(text, sizeof(text), "%-8.2g %6lu NaN %6lu inf %6lu < 0", f.worst.error,
                static_cast<unsigned long>(f.nan), static_cast<unsigned long>(f.infinite),
                static_cast<unsigned long>(f.negative));
  return text;
}

struct Entry {
  const char* name;
  const char* place;
  MaterialSpec spec;
  double float32;         // the error that the naive form exceeds in float32
  double float64 = 0;     // and in float64
  bool improper = false;  // whether it gives NaN, infinite or negative values
};

std::vector<Entry> sharp_lobes() {
  const auto sharp = number(1e6);
  return {
      {"AS, exponent 1e6", "lobe",
       alone("ashikhmin_shirley",
             {{"nu", sharp}, {"nv", sharp}, {"rs", number(0.9)}, {"rd", number(0)}}),
       1e-2, 5e-3},
      {"Phong, exponent 1e6", "lobe", alone("phong", {{"s", sharp}}), 1e-2, 5e-3},
      {"Blinn, exponent 1e6", "lobe", alone("blinn_phong", {{"s", sharp}}), 1e-2, 5e-3},
      {"Beckmann, m 0.0014", "lobe", alone("cook_torrance", {{"m", number(1.4e-3)}}), 1e-2, 5e-3},
      {"GGX, alpha 0.001", "lobe",
       alone("ggx", {{"alpha_x", number(1e-3)}, {"alpha_y", number(1e-3)}}), 5e-3, 1e-3},
      {"Ward, alpha 0.0014", "lobe",
       alone("ward", {{"alpha_x", number(1.4e-3)}, {"alpha_y", number(1.4e-3)}}), 1e-2, 5e-3}};
}

std::vector<Entry> cancellations() {
  const auto on = number(1), off = number(0), shape = number(0.3);
  return {
      {"AS, h to n", "lobe",
       alone("ashikhmin_shirley", {{"nu", number(1e4)}, {"nv", number(10)}, {"rd", off}}), 1e-3,
       1e-3},
      {"Phong, wr.wo to 1", "near_mirror", alone("phong", {{"s", number(1e5)}}), 5e-3, 2e-3},
      {"Schlick at retro-reflection", "retro",
       alone("cook_torrance", {{"m", number(1)}, {"f0", off}}), 1e-2},
      {"AS diffuse at grazing", "grazing",
       alone("ashikhmin_shirley", {{"rd", on}, {"rs", off}, {"scale", off}}), 1e-2},
      {"Cook-Torrance, n.v to 0", "horizon", alone("cook_torrance", {{"m", shape}}), 0, 0, true},
      {"Beckmann, cos(delta) to 0", "horizon", alone("cook_torrance", {{"m", number(2)}}), 0, 0,
       true},
      {"wi = -wo", "exactly_opposite", alone("ggx", {{"alpha_x", shape}, {"alpha_y", shape}}), 0, 0,
       true},
      {"Fresnel, eta < 1", "hemisphere",
       alone("cook_torrance", {{"m", shape}, {"eta", number(0.6)}}), 0, 0, true},
      {"Fresnel at the critical angle", "critical_angle",
       alone("cook_torrance", {{"m", shape}, {"eta", number(0.6)}}), 1e-4, 0, true},
      {"Fresnel, eta to 1", "hemisphere",
       alone("cook_torrance", {{"m", shape}, {"eta", number(1.0001)}}), 1e-3}};
}

std::vector<Entry> beyond() {
  const auto shape = number(0.3), sharp = number(1e4);
  return {
      {"lengths off by 1e-3", "off_unit", alone("blinn_phong", {{"s", sharp}}), 1, 1},
      {"a lobe at grazing", "grazing_lobe",
       alone("ward", {{"alpha_x", number(0.01)}, {"alpha_y", number(0.3)}}), 1, 1},
      {"wo to -wi at the horizon", "opposite",
       alone("ashikhmin_shirley", {{"nu", sharp}, {"nv", sharp}, {"rd", number(0)}}), 1, 1},
      {"negative interreflection", "grazing_lobe",
       alone("oren_nayar", {{"rd", number(0.2)}, {"sigma", number(0.9)}}), 1e-5, 0, true},
      {"1 - cos^2 of Trowbridge-Reitz", "near_mirror",
       alone("ggx", {{"alpha_x", number(0.01)}, {"alpha_y", shape}}), 1e-4, 1e-4},
      {"azimuths of the normal", "axes",
       alone("oren_nayar", {{"rd", number(0.8)}, {"sigma", number(0.5)}}), 1e-5},
      {"a conductor that hardly absorbs", "retro",
       alone("cook_torrance", {{"m", number(1)}, {"eta", number(1.00001)}, {"k", number(1e-6)}}),
       1e-3}};
}

class Stability : public ::testing::TestWithParam<std::vector<Entry> (*)()> {};

TEST_P(Stability, NaiveFormsFailAndTheProductHolds) {
  for (const Entry& entry : GetParam()()) {
    const PlaceReport report = report_at(entry.place, entry.spec);
    std::printf("%-32s %-17s naive32 %s  naive64 %s  fast %.2g  reference %.2g\n", entry.name,
                entry.place, text_of(*report.naive32).c_str(), text_of(*report.naive64).c_str(),
                report.fast.worst.error, report.reference.worst.error);
    EXPECT_GE(report.naive32->worst.error, entry.float32) << entry.name;
    EXPECT_GE(report.naive64->worst.error, entry.float64) << entry.name;
    EXPECT_TRUE(!entry.improper || report.naive32->improper() > 0) << entry.name;
    EXPECT_LE(report.fast.worst.error, kFast) << entry.name;
    EXPECT_LE(report.reference.worst.error, 3e-9) << entry.name;
    EXPECT_EQ(report.fast.improper() + report.reference.improper(), 0U) << entry.name;
    EXPECT_EQ(report.fast.stray + report.reference.stray, 0U) << entry.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Places, Stability, ::testing::Values(sharp_lobes, cancellations, beyond));

// h.k, the cosine of an angle, is above 1 by rounding in a part of all float pairs; 1 - h.k is then
// negative, and so is its fifth power.
TEST(StabilityOfFresnel, NaiveCosinesAreAboveOne) {
  const auto found = std::ranges::find(assess::places(), "same", &assess::HardPlace::name);
  const auto index = static_cast<std::size_t>(found - assess::places().begin());
  const MaterialSpec spec = alone("cook_torrance", {{"m", number(1)}, {"f0", number(0)}});
  std::size_t above = 0;
  const auto pairs =
      assess::rounded(assess::pairs_at(index, subject_of(material_of(spec)), 10'000, 1));
  for (const assess::Pair& p : pairs) {
    const std::array<float, 3> w{static_cast<float>(p.wi[0]), static_cast<float>(p.wi[1]),
                                 static_cast<float>(p.wi[2])};
    above += Naive<float>::dot(Naive<float>::half(w, w), w) > 1 ? 1 : 0;
  }
  std::printf("h.k > 1 in %.1f %% of float pairs with wi = wo\n",
              100. * static_cast<double>(above) / static_cast<double>(pairs.size()));
  EXPECT_GT(above, pairs.size() / 20);
  const PlaceReport report = report_at("same", spec);
  EXPECT_GT(report.naive32->negative, 0U);
  EXPECT_EQ(report.fast.improper(), 0U);
}

// What the library draws for wi by these numbers, in float32.
std::array<float, 3> drawn(const Sampler& sampler, float u, float v) {
  const std::array<float, 3> wi{0.6F, 0, 0.8F}, xi{0.999F, u, v};
  std::array<float, 3> wo{};
  float pdf = 0;
  SampleBatch<float> batch;
  batch.wi = Directions<float>::interleaved(wi.data());
  batch.count = 1;
  batch.xi = xi.data();
  batch.wo = wo.data();
  batch.pdf = &pdf;
  sample(sampler, batch, best_isa());
  return wo;
}

Sampler sampler_of(double nu, double nv) {
  return Sampler::create(material_of(
      alone("ashikhmin_shirley",
            {{"nu", number(nu)}, {"nv", number(nv)}, {"rs", number(1)}, {"rd", number(0)}})));
}

// tan(pi/2) is negative in float: the azimuth of equation 9 flips from v to -v. The library's map
// is continuous there, and at every other quarter.
TEST(StabilityOfSampling, AzimuthsDoNotFlip) {
  constexpr float kPi = 3.14159265358979F;
  EXPECT_LT(std::atan(std::sqrt(101.F / 11.F) * std::tan(kPi * 1.F / 2)), 0);
  const Sampler sampler = sampler_of(100, 10);
  for (const float u : {0.25F, 0.5F, 0.75F}) {
    const auto below = drawn(sampler, std::nextafter(u, 0.F), 0.5F), at = drawn(sampler, u, 0.5F),
               above = drawn(sampler, std::nextafter(u, 1.F), 0.5F);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(below[k], at[k], 1e-5) << u;
      EXPECT_NEAR(above[k], at[k], 1e-5) << u;
    }
  }
}

// (1 - xi)^(1/(e+1)) is 1 in float for a quarter of all xi where e = 1e7.
TEST(StabilityOfSampling, SharpLobesKeepTheirSpread) {
  const Sampler sampler = sampler_of(1e7, 1e7);
  int naive = 0, own = 0;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const float v = (static_cast<float>(i) + 0.5F) / kCount;
    naive += std::pow(1 - v, 1 / (1e7F + 1)) == 1 ? 1 : 0;
    const auto wo = drawn(sampler, 0.3F, v);
    own += wo[0] == -0.6F && wo[1] == 0 ? 1 : 0;
  }
  std::printf("drawn at the very centre of a lobe of exponent 1e7: naive %.1f %%, own %.1f %%\n",
              100. * naive / kCount, 100. * own / kCount);
  EXPECT_GT(naive, kCount / 5);
  EXPECT_LT(own, kCount / 100);
}

}  // namespace
}  // namespace gonio::testing
