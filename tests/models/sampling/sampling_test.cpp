// Every material's sampler against every check. A model added to the registry is tested without a
// line here, but for its density in densities.h.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/harness/harness_sampling.h"
#include "models/harness/hemisphere.h"

namespace gonio::testing {
namespace {

using ::testing::IsEmpty;

constexpr double kLevel = 0.01;  // of all chi-square tests together

class EverySampler : public ::testing::TestWithParam<std::string> {};

TEST_P(EverySampler, DrawsByItsDensity) {
  const double level = sidak(kLevel, 2 * count_of_places());
  const std::vector<Place> places = places_of(GetParam());
  std::size_t blurred = 0;
  for (const Place& place : places) {
    SCOPED_TRACE(place.name);
    const Sampler sampler = sampler_of(place.spec);
    const auto exact = library_sampling<double>(place.spec, sampler, best_isa());
    const auto fast = library_sampling<float>(place.spec, sampler, best_isa());
    const Integrated integrated = integrate(exact, place);
    EXPECT_THAT(check_total(integrated), IsEmpty());
    EXPECT_THAT(check_distribution(exact, place, integrated, level), IsEmpty());
    EXPECT_THAT(check_distribution(fast, place, integrated, level), IsEmpty());
    EXPECT_THAT(check_albedo(exact, place, integrated), IsEmpty());
    EXPECT_THAT(check_albedo(fast, place, integrated), IsEmpty());
    blurred += integrated.blurs_float32 ? 1 : 0;
  }
  EXPECT_LT(blurred, places.size() / 4) << "what float32 draws went all but unseen";
}

TEST_P(EverySampler, WeighsByTheOraclesValuesAndDensities) {
  for (const Place& place : places_of(GetParam())) {
    SCOPED_TRACE(place.name);
    const Sampler sampler = sampler_of(place.spec);
    for (const Isa isa : supported_isas()) {
      SCOPED_TRACE(name_of(isa));
      const auto exact = library_sampling<double>(place.spec, sampler, isa);
      const auto fast = library_sampling<float>(place.spec, sampler, isa);
      EXPECT_THAT(check_samples(exact, place, isa), IsEmpty());
      EXPECT_THAT(check_samples(fast, place, isa), IsEmpty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EverySampler, ::testing::ValuesIn(models_with_cases()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace gonio::testing
