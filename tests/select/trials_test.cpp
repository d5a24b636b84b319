// A few of the trials that `select_bench` runs by the hundred.
#include "select/trials.h"

#include <gtest/gtest.h>

#include "effort.h"

namespace gonio::testing {
namespace {

class Trials : public ::testing::TestWithParam<Truth> {};

TEST_P(Trials, RecoverTheGeneratingModel) {
  const Trial trial = run_trial(GetParam(), 1);
  EXPECT_EQ(trial.chosen, GetParam().name) << trial.selection.reason;
}

// Under sanitizers, where each takes many seconds, every third.
std::vector<Truth> tried() {
  std::vector<Truth> some;
  constexpr std::size_t kStep = kSlower > 1 ? 3 : 1;
  for (std::size_t i = 0; i < truths().size(); i += kStep) some.push_back(truths()[i]);
  return some;
}

std::string name_of(const ::testing::TestParamInfo<Truth>& test) {
  std::string name;
  for (const char c : test.param.name)
    if (std::isalnum(c) != 0) name += c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(Truths, Trials, ::testing::ValuesIn(tried()), name_of);

}  // namespace
}  // namespace gonio::testing
