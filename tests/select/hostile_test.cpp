// References and options that cannot be used: errors that name the field, the value and what is
// allowed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "fit/synthetic.h"
#include "gonio/measured/table.h"
#include "measured/synthetic_merl.h"
#include "select/trials.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;
using Numbers = std::vector<double>;

const MaterialSpec kGrey{LobeSpec{"lambertian", {{"rd", Numbers{0.5}}}}, {}, {}};

fit::Data constant(double value) {
  const Pairs at = scattered_pairs(1000, 1);
  return *fit::from_pairs(at.wi, at.wo, Numbers(1000, value), 1, at.weights);
}

Error error_of(const fit::Data& data, const select::Scene& scene = scene_to(75, 0.1),
               const select::Options& options = trial_options(1)) {
  const auto found = select::choose(data, scene, options);
  EXPECT_FALSE(found.ok());
  return found ? Error{} : found.error();
}

TEST(HostileSelection, ReferenceOfNaN) {
  const Error error = error_of(constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(error.field, "reference");
  EXPECT_THAT(error.value, HasSubstr("0 usable pairs of 1000 (1000 not finite"));
  EXPECT_THAT(error.allowed, HasSubstr("at least 200"));
}

TEST(HostileSelection, ReferenceThatIsNotMeasured) {
  EXPECT_THAT(error_of(constant(-1)).value, HasSubstr("1000 negative"));
}

// A table of a diffuse surface, of which a goniometer saw nothing beyond 50 degrees of difference:
// a diffuse model is right where something is known.
TEST(HostileSelection, HolesOfATableSayNothing) {
  const auto values = tabulate([](double, double theta_d, double) {
    const double f = theta_d > 0.87 ? -1 : 0.15;
    return Rgb{f, f, f};
  });
  const auto table = MeasuredTable::from_values(values);
  ASSERT_TRUE(table.ok());
  select::Options options = trial_options(1);
  options.costs["reference"] = 1000;
  const auto found = select::choose(Material::from_table(*table, Interpolation::linear),
                                    scene_to(75, 0.05), options);
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_TRUE(found->choice);
  EXPECT_EQ(found->entries[found->choice->entry].name, "lambertian");
  EXPECT_LT(found->choice->error.upper, 0.02);
}

TEST(HostileSelection, ReferenceThatReflectsNothing) {
  EXPECT_THAT(error_of(constant(0)).value, HasSubstr("0 everywhere"));
  const auto black = Material::create({LobeSpec{"lambertian", {{"rd", Numbers{0}}}}, {}, {}});
  const auto found = select::choose(*black, scene_to(75, 0.1), trial_options(1));
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().field, "reference");
}

TEST(HostileSelection, ReferenceThatIsElsewhere) {
  const Error error = error_of(constant(0.1), scene_to(0.1, 0.1));
  EXPECT_THAT(error.value, HasSubstr("outside the scene"));
}

TEST(HostileSelection, ScenesAreChecked) {
  EXPECT_EQ(error_of(constant(0.1), {}).field, "scene");
  EXPECT_EQ(error_of(constant(0.1), scene_to(75, 0)).field, "scene.tolerance");
}

TEST(HostileSelection, ColourDifferencesAreOfColours) {
  const Pairs at = scattered_pairs(1000, 1);
  const auto two = fit::from_pairs(at.wi, at.wo, Numbers(2000, 0.1), 2, at.weights);
  select::Scene scene = scene_to(75, 1);
  scene.metric = select::Metric::delta_e;
  const Error error = error_of(*two, scene);
  EXPECT_EQ(error.field, "scene.metric");
  EXPECT_EQ(error.value, "delta_e of 2 channels");
}

TEST(HostileSelection, OptionsAreChecked) {
  const auto with = [](const auto& change) {
    select::Options options = trial_options(1);
    change(options);
    return error_of(constant(0.1), scene_to(75, 0.1), options);
  };
  EXPECT_EQ(with([](auto& o) { o.lobes = 3; }).field, "options.lobes");
  EXPECT_EQ(with([](auto& o) { o.starts = 0; }).field, "options.starts");
  EXPECT_EQ(with([](auto& o) { o.sizes.validation = 1; }).field, "options.sizes.validation");
  EXPECT_EQ(with([](auto& o) { o.costs.erase("ward"); }).value, "without \"ward\"");
  EXPECT_EQ(with([](auto& o) { o.costs["ward"] = 0; }).field, "options.costs.ward");
}

TEST(HostileSelection, CanBeCancelled) {
  select::Options options = trial_options(1);
  options.stop = [] { return true; };
  EXPECT_EQ(error_of(constant(0.1), scene_to(75, 0.1), options).code, ErrorCode::cancelled);
}

// What no candidate can do is said, not returned.
TEST(HostileSelection, NothingIsGoodEnough) {
  const fit::Data data = data_of(kGrey, scattered_pairs(2000, 1), 0.5);
  select::Options options = trial_options(1);
  options.lobes = 1;
  select::Scene scene = scene_to(75, 0.01);
  scene.anisotropy = false;
  const auto found = select::choose(data, scene, options);
  ASSERT_TRUE(found.ok());
  EXPECT_FALSE(found->choice);
  EXPECT_THAT(found->reason, HasSubstr("no candidate meets the tolerance of 0.01"));
}

}  // namespace
}  // namespace gonio::testing
