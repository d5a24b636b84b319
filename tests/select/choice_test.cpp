// What is chosen, and what is said of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "effort.h"
#include "fit/report/metrics.h"
#include "fit/synthetic.h"
#include "select/trials.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;
using Numbers = std::vector<double>;

MaterialSpec varnished() {
  return {
      {},
      LobeSpec{"lambertian", {{"rd", Numbers{0.5, 0.3, 0.2}}}},
      {LobeSpec{"ggx",
                {{"alpha_x", Numbers{0.25}}, {"alpha_y", Numbers{0.25}}, {"eta", Numbers{1.5}}}}}};
}

select::Selection chosen(const MaterialSpec& reference, const select::Scene& scene,
                         select::Options options = trial_options(1)) {
  const auto found = select::choose(*Material::create(reference), scene, options);
  // Ends the test: without a choice there is nothing to look at.
  if (!found) throw std::runtime_error(found.error().message);
  if (!found->choice) throw std::runtime_error(found->reason);
  return *found;
}

const select::Entry& entry_of(const select::Selection& found) {
  return found.entries[found.choice->entry];
}

// Grazing views see the Fresnel term and the lobe; those near the normal a diffuse surface.
TEST(Choice, NearTheNormalIsCheaper) {
  const auto near = chosen(varnished(), scene_to(20, 0.1));
  const auto grazing = chosen(varnished(), scene_to(85, 0.1));
  EXPECT_LT(entry_of(near).cost, entry_of(grazing).cost) << near.reason << "\n" << grazing.reason;
  EXPECT_THAT(grazing.reason, HasSubstr("degrees it would do"));
  EXPECT_THAT(grazing.reason, HasSubstr("is where the larger angle is 75 to 90 degrees"));
}

TEST(Choice, LargerTolerancesAreCheaper) {
  const auto close = chosen(varnished(), scene_to(75, 0.02));
  const auto rough = chosen(varnished(), scene_to(75, 0.6));
  EXPECT_LT(entry_of(rough).cost, entry_of(close).cost);
  EXPECT_EQ(entry_of(rough).name, "lambertian");
  EXPECT_THAT(rough.reason, HasSubstr("Nothing costs less"));
}

// A difference of colour that is just seen: the lobe counts by what a picture shows of it.
TEST(Choice, GoesByColoursToo) {
  select::Scene scene = scene_to(75, 1.5);
  scene.metric = select::Metric::delta_e;
  const auto close = chosen(varnished(), scene);
  EXPECT_LT(close.choice->error.upper, 1.5);
  EXPECT_NE(entry_of(close).name, "lambertian");
  scene.tolerance = 40;
  EXPECT_EQ(entry_of(chosen(varnished(), scene)).name, "lambertian");
}

// Numbers come out as short as the tolerance lets them, and are what was certified.
TEST(Choice, RoundsItsNumbers) {
  const auto found = chosen(varnished(), scene_to(75, 0.02));
  const select::Choice& choice = *found.choice;
  EXPECT_GE(choice.digits, 2U);
  EXPECT_LE(choice.digits, 4U);
  EXPECT_LT(choice.error.upper, 0.02);
  EXPECT_GT(choice.confidence, 0.97);
  const auto fresh = select::draw_pairs(*Material::create(varnished()),
                                        select::Distribution(scene_to(75, 1)), 50'000, 77);
  const auto rounded = Material::create(*choice.material);
  ASSERT_TRUE(rounded.ok());
  EXPECT_NEAR(fit::compare(*rounded, fresh, 0).errors.all.l1, choice.error.value,
              0.2 * choice.error.value);
}

// The front falls: what costs more errs less. What is not on it says why.
TEST(Choice, TheFrontFalls) {
  select::Options options = trial_options(1);
  options.whole_front = true;
  options.lobes = 1;
  select::Scene scene = scene_to(75, 0.1);
  scene.anisotropy = false;
  const auto found = chosen(varnished(), scene, options);
  double cost = 0, error = 1e300;
  std::size_t on_front = 0;
  for (const select::Entry& entry : found.entries) {
    EXPECT_GE(entry.cost, cost);
    cost = entry.cost;
    if (!entry.on_front) {
      EXPECT_FALSE(entry.remark.empty()) << entry.name;
      continue;
    }
    ++on_front;
    EXPECT_LT(entry.error.value, error) << entry.name;
    error = entry.error.value;
  }
  EXPECT_GE(on_front, 3U);
  EXPECT_LT(on_front, found.entries.size() / 2);
}

// Where every candidate holds as much memory, the fewest numbers win.
TEST(Choice, OfBytesIsOneOfTheSmallest) {
  select::Scene scene = scene_to(75, 0.6);
  scene.cost = select::CostKind::bytes;
  EXPECT_EQ(entry_of(chosen(varnished(), scene)).name, "lambertian");
}

// Paths carry a lobe's variance: what is drawn badly costs more.
TEST(Choice, WeighsVariance) {
  select::Scene scene = scene_to(90, kSlower > 1 ? 0.3 : 0.05);
  scene.lights = select::Lights::environment;
  scene.cost = select::CostKind::ns_variance;
  select::Options options = trial_options(1);
  options.lobes = 1;
  scene.anisotropy = false;
  const auto found = chosen(varnished(), scene, options);
  for (const select::Entry& entry : found.entries) {
    EXPECT_GE(entry.second_moment, 1 - 1e-3) << entry.name;
    EXPECT_DOUBLE_EQ(entry.cost, entry.ns * entry.second_moment);
  }
}

// At a tolerance that float32 cannot keep, float64; at ten times that no more.
TEST(Choice, TakesFloat64OnlyWhereItBuysSomething) {
  select::Options options = trial_options(1);
  options.lobes = 1;
  select::Scene scene = scene_to(75, 1);
  scene.anisotropy = false;
  const Material reference = *Material::create(varnished());
  const select::Blocks pairs(
      select::draw_pairs(reference, select::Distribution(scene), 20'000, 77));
  // The reference's values are float32: they are off by this from the float64 ones of their own
  // material, and by both from float32 ones.
  const double rounding =
      bounded(errors_of(reference, pairs, scene.metric), scene.metric, 0.5).value;
  const double float32 = float32_error(reference, pairs, scene.metric);
  ASSERT_GT(float32, 0.5 * rounding);
  scene.tolerance = 1.1 * rounding + 0.5 * float32;
  const auto exact = chosen(varnished(), scene, options);
  EXPECT_TRUE(exact.choice->needs_float64) << exact.reason;
  EXPECT_GT(exact.choice->error.upper + exact.choice->float32_error, scene.tolerance);
  scene.tolerance *= 10;
  const auto usual = chosen(varnished(), scene, options);
  EXPECT_FALSE(usual.choice->needs_float64) << usual.reason;
}

// A goniometer that holds the light in one plane sees nothing of a surface turned: a lobe that is
// wider along than across the plane is no reason for an anisotropic material.
TEST(Choice, SeesNoAnisotropyInOnePlane) {
  Pairs pairs = scattered_pairs(6000, 1);
  for (std::size_t i = 0; i < pairs.weights.size(); ++i) {
    double *wi = &pairs.wi[3 * i], *wo = &pairs.wo[3 * i];
    const double r = std::hypot(wi[0], wi[1]), c = wi[0] / r, s = wi[1] / r;
    const double x = c * wo[0] + s * wo[1], y = c * wo[1] - s * wo[0];
    wi[0] = r, wi[1] = 0, wo[0] = x, wo[1] = y;
  }
  const MaterialSpec stretched{
      LobeSpec{"ggx", {{"alpha_x", Numbers{0.2}}, {"alpha_y", Numbers{0.4}}, {"fresnel", "none"}}},
      {},
      {}};
  select::Options options = trial_options(1);
  options.lobes = 1;
  const auto found = select::choose(data_of(stretched, pairs), scene_to(75, 0.02), options);
  ASSERT_TRUE(found.ok()) << found.error().message;
  for (const select::Entry& entry : found->entries) {
    if (entry.name.ends_with(", anisotropic")) {
      EXPECT_FALSE(entry.on_front) << entry.name;
    }
  }
}

TEST(Choice, IsTheSameForTheSameSeed) {
  const auto a = chosen(varnished(), scene_to(75, 0.05)),
             b = chosen(varnished(), scene_to(75, 0.05));
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.entries.size(), b.entries.size());
}

}  // namespace
}  // namespace gonio::testing
