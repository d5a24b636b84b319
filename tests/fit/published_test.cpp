// Fits of measured materials: as good as they can be, whatever the start, and better than
// published. tests/bench/fit_bench.cpp prints the whole tables; here is a part of each.
#include "fit/published.h"

#include <gtest/gtest.h>

#include "fit/data/data.h"
#include "fit/fit.h"
#include "fit/real_data.h"
#include "fit/report/metrics.h"
#include "measured/pairs.h"
#include "measured/solid_angle.h"

namespace gonio::testing {
namespace {

// The errors of Cook and Torrance's lobe at theta <= 80 degrees that are known to be reachable.
constexpr std::array kReachable{0.295, 0.277, 0.049, 0.079, 0.360, 0.251, 0.134, 0.0157};

TEST(MeasuredMaterials, AreFittedAsWellAsIsKnown) {
  for (std::size_t i = 0; i < kFitMaterials.size(); ++i) {
    const auto data = load_measured(kFitMaterials[i]);
    if (!data) GTEST_SKIP() << "no " << kFitMaterials[i] << " in " << data_folder();
    fit::Options options;
    options.max_theta = fit::kGrazing;
    const auto result = fit::fit(*data, over_lambertian("cook_torrance", "dielectric"), options);
    ASSERT_TRUE(result.ok());
    const double l1 = result->certificate.errors.below_80.l1;
    EXPECT_LT(l1, 1.005 * kReachable[i]) << kFitMaterials[i];
    for (const char* table : {"low_cooktorrance_E1", "low_cooktorrance_E2", "ngan_cooktorrance"}) {
      for (const MaterialSpec& spec : published(table, kFitMaterials[i])) {
        const auto theirs = Material::create(spec);
        ASSERT_TRUE(theirs.ok()) << theirs.error().message;
        EXPECT_LE(l1, fit::compare(*theirs, *data, 0).errors.below_80.l1) << table;
      }
    }
  }
}

// That the published parameters are read as they were meant.
TEST(PublishedParameters, HaveTheErrorsKnownForThem) {
  const auto nickel = load_measured("nickel"), bball = load_measured("white-diffuse-bball");
  if (!nickel || !bball) GTEST_SKIP() << "no nickel in " << data_folder();
  const auto error = [](const char* table, const char* name, const fit::Data& data) {
    const auto material = Material::create(published(table, name).at(0));
    return fit::compare(*material, data, 0).errors.below_80.l1;
  };
  EXPECT_NEAR(error("low_cooktorrance_E2", "nickel", *nickel), 0.3984, 1e-4);
  EXPECT_NEAR(error("low_cooktorrance_E2", "white-diffuse-bball", *bball), 0.0209, 1e-4);
}

TEST(MeasuredMaterials, AreFittedAlikeFromAnyStart) {
  for (const char* name : {"chrome", "red-fabric2"}) {
    const auto all = load_measured(name, 0.1, 0.02);
    if (!all) GTEST_SKIP() << "no " << name << " in " << data_folder();
    const fit::Data data = fit::subset(fit::within(*all, 0, fit::kGrazing), 20'000, 3);
    for (const char* model : {"phong", "blinn_phong", "phong_mix", "cook_torrance"}) {
      std::mt19937_64 random(1);
      std::vector<double> ends;
      for (int start = 0; start < 3; ++start) {
        MaterialSpec form = over_lambertian(model, "dielectric");
        draw_start(random, form.specular[0]);
        ends.push_back(fit::fit(data, form, {})->certificate.stages.back().objective);
      }
      const auto [least, most] = std::minmax_element(ends.begin(), ends.end());
      EXPECT_LT(*most, 1.01 * *least) << name << " " << model;
    }
  }
}

// Where a coarse search takes the wrong one of two basins, a guess in the other is followed; where
// it takes the right one, no guess makes it worse.
TEST(MeasuredMaterials, AreFittedNoWorseAndSometimesBetterWithAGuess) {
  const auto nickel = load_measured("nickel");
  if (!nickel) GTEST_SKIP() << "no nickel in " << data_folder();
  const fit::Data data = fit::subset(fit::within(*nickel, 0, fit::kGrazing), 20'000, 1);
  int better = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    fit::Options options;
    options.seed = seed;
    options.starts = 1;
    options.scan_pairs = 500;
    options.fit_pairs = 3000;
    MaterialSpec form = over_lambertian("cook_torrance", "dielectric");
    const double without = fit::fit(data, form, options)->certificate.stages.back().objective;
    for (const double eta : {2.0, 100.0}) {
      form.specular[0].parameters["eta"] = std::vector{eta};
      const double with = fit::fit(data, form, options)->certificate.stages.back().objective;
      EXPECT_LE(with, without) << "seed " << seed << ", eta " << eta;
      better += with < 0.995 * without ? 1 : 0;
    }
  }
  EXPECT_GT(better, 0);
}

// Bounds that other fitters impose hide an optimum: s >= .3 the fabric's, a scale <= 1 nickel's.
TEST(MeasuredMaterials, AreNotHeldByBoundsThatOthersImpose) {
  const auto fabric = load_measured("red-fabric2"), nickel = load_measured("nickel");
  if (!fabric || !nickel) GTEST_SKIP() << "no nickel in " << data_folder();
  fit::Options options;
  options.max_theta = fit::kGrazing;
  const auto number = [](const MaterialSpec& spec, const char* name) {
    const auto& numbers = std::get<std::vector<double>>(spec.specular[0].parameters.at(name));
    return *std::max_element(numbers.begin(), numbers.end());
  };
  const auto phong =
      fit::fit(fit::subset(*fabric, 20'000, 1), over_lambertian("phong", "dielectric"), options);
  EXPECT_LT(number(phong->material, "s"), 0.3);
  const auto metal = fit::fit(fit::subset(*nickel, 20'000, 1),
                              over_lambertian("phong_mix", "dielectric"), options);
  EXPECT_GT(number(metal->material, "scale"), 1);
}

// No model here has a lobe toward the light.
TEST(RetroReflectors, AreSaidToBeNoneOfTheModels) {
  for (const char* tape : {"retro-3M-jaune.dat", "retro-gray-tape.dat"}) {
    const auto pairs = read_alta(data_folder() / "retro" / tape);
    if (!pairs) GTEST_SKIP() << pairs.error().message;
    const auto data = fit::from_pairs(pairs->wi, pairs->wo, pairs->values, pairs->channels,
                                      pair_measures(pairs->wi, pairs->wo));
    const auto result = fit::fit(*data, over_lambertian("cook_torrance", "dielectric"), {});
    EXPECT_EQ(result->certificate.verdict, fit::Verdict::failed) << tape;
    EXPECT_NE(result->certificate.reason.find("retro-reflection"), std::string::npos)
        << result->certificate.reason;
    const fit::Regions& regions = result->certificate.regions;
    EXPECT_GT(regions.toward_light.error, regions.mirror.error) << tape;
  }
}

// Nickel's data hardly know a metal from a strong dielectric.
TEST(MeasuredMaterials, TellOfTwoBasins) {
  const auto nickel = load_measured("nickel");
  if (!nickel) GTEST_SKIP() << "no nickel in " << data_folder();
  fit::Options options;
  options.max_theta = fit::kGrazing;
  const auto result = fit::fit(*nickel, over_lambertian("cook_torrance", "dielectric"), options);
  EXPECT_EQ(result->certificate.verdict, fit::Verdict::ambiguous);
  EXPECT_NE(result->certificate.reason.find("eta"), std::string::npos)
      << result->certificate.reason;
}

// The cells' weights measure all pairs of directions over the hemisphere.
TEST(MeasuredMaterials, HaveWeightsThatMeasureDirections) {
  double sum = 0;
  for (int h = 0; h < 90; ++h) {
    for (int d = 0; d < 90; ++d) {
      for (int p = 0; p < 180; ++p) sum += fit::cell_measure(h, d, p);
    }
  }
  EXPECT_NEAR(sum / (4 * std::numbers::pi * std::numbers::pi), 1, 1e-4);
}

}  // namespace
}  // namespace gonio::testing
