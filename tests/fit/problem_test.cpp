// A problem's gradient against central differences of its cost, by every parameter of every model.
#include "fit/search/problem.h"

#include <gtest/gtest.h>

#include "fit/cases.h"
#include "fit/linear/solved_colours.h"
#include "fit/search/search.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

// Somewhere beside the optimum, inside all bounds.
std::vector<double> beside(const fit::Problem& problem) {
  std::vector<double> shapes = fit::guess_of(problem.form());
  for (double& u : shapes) u += 0.03;
  std::vector<double> x = fit::solve_colours(problem, shapes, 2).parameters;
  for (std::size_t i = shapes.size(); i < x.size(); ++i) x[i] = 0.9 * x[i] + 0.01;
  return x;
}

void expect_gradient(const Case& of, const fit::Data& data, fit::Objective objective) {
  const auto form = fit::make_form(of.truth, {of.anisotropic});
  ASSERT_TRUE(form.ok()) << form.error().message;
  const fit::Problem problem(*form, data, {objective, 0.01, 0.1}, true);
  std::vector<double> x = beside(problem);
  const fit::Equations e = problem.equations(x, {});
  EXPECT_NEAR(e.cost, problem.cost(x, false, {}), 1e-12 * e.cost);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const double here = x[i], step = 1e-5 * std::max(std::abs(here), 0.1);
    x[i] = here + step;
    const double above = problem.cost(x, false, {});
    x[i] = here - step;
    const double below = problem.cost(x, false, {});
    x[i] = here;
    EXPECT_GT(e.matrix(at, at), 0) << "parameter " << i;
    EXPECT_NEAR(e.gradient[at], (above - below) / (2 * step),
                1e-6 * std::sqrt(2 * e.cost * e.matrix(at, at)))
        << name_of(objective) << ", parameter " << i << " at " << here;
  }
}

class Gradient : public ::testing::TestWithParam<Case> {};

TEST_P(Gradient, IsThatOfTheCost) {
  const fit::Data data = data_of(GetParam().truth, scattered_pairs(300, 1), 0.1);
  for (int objective = 0; objective < fit::kObjectiveCount; ++objective)
    expect_gradient(GetParam(), data, static_cast<fit::Objective>(objective));
}

INSTANTIATE_TEST_SUITE_P(Models, Gradient, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

// What is read of n pairs is the first n of what is read of more; a problem of any number of pairs
// sums each once.
TEST(ProblemSizes, ArraysOfAnyLengthAreReadAlike) {
  const Pairs at = scattered_pairs(4001, 1);
  std::vector<double> values(4001);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.1 + 1e-4 * static_cast<double>(i);
  const auto first = [&](std::size_t n) {
    return *fit::from_pairs(std::span(at.wi).first(3 * n), std::span(at.wo).first(3 * n),
                            std::span(values).first(n), 1, std::span(at.weights).first(n));
  };
  const fit::Data all = first(4001);
  const auto form = fit::make_form({LobeSpec{"lambertian", {}}, {}, {}}, {});
  ASSERT_TRUE(form.ok());
  for (const std::size_t n : {1, 2, 3, 5, 4001}) {
    const fit::Data data = first(n);
    ASSERT_EQ(data.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(data.values[i], all.values[i]);
      EXPECT_EQ(data.wi[0][i], all.wi[0][i]);
      EXPECT_EQ(data.wo[2][i], all.wo[2][i]);
    }
    // Costs are parts of that of a material that reflects nothing.
    const fit::Problem problem(*form, data, {fit::Objective::l2, 0, 1}, true);
    EXPECT_NEAR(problem.cost(std::vector<double>{0}, false, {}), 1, 1e-12) << n;
  }
}

}  // namespace
}  // namespace gonio::testing
