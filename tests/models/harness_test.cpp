// Every model of the registry against every check. A model added there is tested without a line
// here.
#include "models/harness/harness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

namespace gonio::testing {
namespace {

using ::testing::IsEmpty;

class EveryModel : public ::testing::TestWithParam<std::string> {
 protected:
  const Subject subject_ = library_subject(GetParam());
};

TEST_P(EveryModel, DescribesItself) { EXPECT_THAT(check_description(subject_), IsEmpty()); }
TEST_P(EveryModel, IsTrueToTheOracle) { EXPECT_THAT(check_accuracy(subject_), IsEmpty()); }
TEST_P(EveryModel, IsReciprocal) { EXPECT_THAT(check_reciprocity(subject_), IsEmpty()); }
TEST_P(EveryModel, TurnsWithTheSurface) { EXPECT_THAT(check_rotation(subject_), IsEmpty()); }
TEST_P(EveryModel, DoesNotJump) { EXPECT_THAT(check_continuity(subject_), IsEmpty()); }
TEST_P(EveryModel, GainsNoEnergyUnsaid) { EXPECT_THAT(check_energy(subject_), IsEmpty()); }
TEST_P(EveryModel, IsProperEverywhere) {
  EXPECT_THAT(check_proper(subject_, 10'000'000), IsEmpty());
}
TEST_P(EveryModel, HasTheOraclesDerivatives) {
  EXPECT_THAT(check_derivatives(subject_), IsEmpty());
}

TEST_P(EveryModel, SaysWhatItLosesOrGains) {
  const double limit = subject_.description.albedo_limit;
  const AlbedoRange range = white_albedos(subject_);
  if (limit > 1) {
    EXPECT_GT(range.highest, 1 + (limit - 1) / 2) << "gains less than it says";
  }
  RecordProperty("lowest white albedo", std::to_string(range.lowest));
  RecordProperty("highest white albedo", std::to_string(range.highest));
  std::cout << GetParam() << ": white albedo from " << range.lowest << " (" << range.lowest_at
            << " degrees) to " << range.highest << "\n";
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(analytic_models()),
                         [](const auto& name) { return name.param; });

TEST(Harness, QuadratureIntegratesAConstant) { EXPECT_LT(quadrature_error(), 1); }

TEST(Harness, DescribesTheMeasuredModel) {
  EXPECT_THAT(check_description(
                  {.description = models().back(), .fast = {}, .reference = {}, .derivative = {}}),
              IsEmpty());
}

}  // namespace
}  // namespace gonio::testing
