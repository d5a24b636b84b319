// A value that no reflectance could be is said, and no fit to it is "converged".
#include "fit/data/outliers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fit/fit.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

fit::Data data_with(double value, std::size_t count, double other = 0.1) {
  const Pairs at = scattered_pairs(4001, 1);
  std::vector<double> values(4001, other);
  for (std::size_t i = 0; i < count; ++i) values[1000 * (i + 1)] = value;
  return *fit::from_pairs(at.wi, at.wo, values, 1, at.weights);
}

TEST(Outliers, AreFoundAndFailTheFit) {
  const fit::Data data = data_with(1e30, 1);
  EXPECT_THAT(fit::outliers_of(data),
              AllOf(HasSubstr("1 value of channel 0 is far out: 1e+30 1/sr at theta_i"),
                    HasSubstr("times the next")));
  EXPECT_THAT(fit::outliers_of(data_with(1e30, 3)), HasSubstr("3 values of channel 0 are far out"));
  // A bound holds what follows 1e30, and is the verdict; what follows 0.1 is inside the bounds.
  const MaterialSpec form{LobeSpec{"lambertian", {}}, {}, {}};
  const auto held = fit::fit(data, form, {}), inside = fit::fit(data_with(0.1, 1, 1e-6), form, {});
  ASSERT_TRUE(held.ok() && inside.ok());
  EXPECT_EQ(held->certificate.verdict, fit::Verdict::bound_limited);
  EXPECT_THAT(held->certificate.reason, HasSubstr("far out: 1e+30 1/sr"));
  EXPECT_EQ(inside->certificate.verdict, fit::Verdict::failed);
  EXPECT_THAT(inside->certificate.reason, HasSubstr("far out"));
}

TEST(Outliers, AreNoSharpLobes) {
  EXPECT_THAT(fit::outliers_of(data_with(0.1, 0)), IsEmpty());
  EXPECT_THAT(fit::outliers_of(data_with(90, 1)), IsEmpty());
  const Pairs at = scattered_pairs(4001, 1);
  std::vector<double> values;  // down by a third from each to the next
  for (std::size_t i = 0; i < 4001; ++i)
    values.push_back(0.01 + 1e5 * std::exp(-0.4 * static_cast<double>(i)));
  EXPECT_THAT(fit::outliers_of(*fit::from_pairs(at.wi, at.wo, values, 1, at.weights)), IsEmpty());
  for (const std::size_t size : {1, 2, 3, 5}) {
    const Pairs few = scattered_pairs(size, 1);
    EXPECT_THAT(fit::outliers_of(
                    *fit::from_pairs(few.wi, few.wo, std::vector<double>(size, 1), 1, few.weights)),
                IsEmpty());
  }
}

}  // namespace
}  // namespace gonio::testing
