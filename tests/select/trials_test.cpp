// A few of the trials that `select_bench` runs by the hundred.
#include "select/trials.h"

#include <gtest/gtest.h>

namespace gonio::testing {
namespace {

class Trials : public ::testing::TestWithParam<Truth> {};

TEST_P(Trials, RecoverTheGeneratingModel) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Trial trial = run_trial(GetParam(), seed);
    EXPECT_EQ(trial.chosen, GetParam().name) << "seed " << seed << ": " << trial.selection.reason;
  }
}

std::string name_of(const ::testing::TestParamInfo<Truth>& test) {
  std::string name;
  for (const char c : test.param.name)
    if (std::isalnum(c) != 0) name += c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(Truths, Trials, ::testing::ValuesIn(truths()), name_of);

}  // namespace
}  // namespace gonio::testing
