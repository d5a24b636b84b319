// A value that no reflectance could be is said, and no fit to it is "converged".
#include "fit/outliers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fit/fit.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

fit::Data data_with(double value, std::size_t count) {
  const Pairs at = scattered_pairs(4001, 1);
  std::vector<double> values(4001, 0.1);
  for (std::size_t i = 0; i < count; ++i) values[1000 * (i + 1)] = value;
  return *fit::from_pairs(at.wi, at.wo, values, 1, at.weights);
}

TEST(Outliers, AreFoundAndFailTheFit) {
  const fit::Data data = data_with(1e30, 1);
  EXPECT_THAT(fit::outliers_of(data),
              AllOf(HasSubstr("1 value of channel 0 is far out: 1e+30 1/sr at theta_i"),
                    HasSubstr("times the next")));
  MaterialSpec form{LobeSpec{"lambertian", {}}, {}, {}};
  const auto fitted = fit::fit(data, form, {});
  ASSERT_TRUE(fitted.ok());
  EXPECT_NE(fitted->certificate.verdict, fit::Verdict::converged);
  EXPECT_THAT(fitted->certificate.reason, HasSubstr("far out: 1e+30 1/sr"));
  EXPECT_THAT(fit::outliers_of(data_with(1e30, 3)), HasSubstr("3 values of channel 0 are far out"));
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
