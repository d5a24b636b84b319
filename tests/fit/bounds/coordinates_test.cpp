// Colours and coefficients are two names of one material; least squares keep to both's bounds.
#include "fit/bounds/coordinates.h"

#include <gtest/gtest.h>

#include <random>

#include "fit/bounds/coefficient_bounds.h"
#include "fit/cases.h"
#include "fit/synthetic.h"
#include "gonio/models/description.h"

namespace gonio::testing {
namespace {

class BoundCoordinates : public ::testing::TestWithParam<Case> {};

// Shapes at their start and coefficients that only the largest colours have.
std::vector<double> bright(const fit::Form& form) {
  std::vector<double> x;
  for (const fit::ShapeParameter& shape : form.shapes)
    x.push_back(shape.scale.to_search(shape.start));
  x.resize(form.parameters(3), 1e9);
  return fit::within_bounds(form, x, 3);
}

TEST_P(BoundCoordinates, GoThereAndBackWithTheirSlopes) {
  const auto form = fit::make_form(GetParam().truth, {GetParam().anisotropic});
  ASSERT_TRUE(form.ok());
  const std::vector<double> x = bright(*form);
  fit::Coordinates coordinates(*form, 3);
  coordinates.follow(x, 0.5);
  EXPECT_FALSE(coordinates.follow(x, 0.5));  // all that is there has been found
  std::vector<double> y = coordinates.from_parameters(x);
  const auto back = coordinates.to_parameters(y);
  const auto bounds = coordinates.bounds();
  const Eigen::MatrixXd slopes = coordinates.slopes(y);
  for (std::size_t j = 0; j < y.size(); ++j) {
    EXPECT_NEAR(back[j], x[j], 1e-12 * std::abs(x[j])) << j;
    EXPECT_LE(y[j], bounds.upper[j]);
    EXPECT_FALSE(coordinates.fields(j).empty());
    const double here = y[j], step = 1e-6 * std::max(std::abs(here), 1e-3);
    y[j] = here + step;
    const auto above = coordinates.to_parameters(y);
    y[j] = here - step;
    const auto below = coordinates.to_parameters(y);
    y[j] = here;
    for (std::size_t i = 0; i < y.size(); ++i) {
      EXPECT_NEAR(slopes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                  (above[i] - below[i]) / (2 * step), 1e-5 * (1 + std::abs(x[i])))
          << i << " by " << j;
    }
  }
}

TEST_P(BoundCoordinates, LeaveWhatIsInsideAsItIs) {
  const auto form = fit::make_form(GetParam().truth, {GetParam().anisotropic});
  ASSERT_TRUE(form.ok());
  std::vector<double> x = bright(*form);
  for (std::size_t i = form->shapes.size(); i < x.size(); ++i) x[i] = 1e-3;
  fit::Coordinates coordinates(*form, 3);
  EXPECT_FALSE(coordinates.follow(x, 0.999));
  EXPECT_TRUE(coordinates.plain());
  EXPECT_EQ(fit::within_bounds(*form, x, 3), x);
}

INSTANTIATE_TEST_SUITE_P(Models, BoundCoordinates, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

// Of random problems, against random points inside the bounds: none is better.
TEST(CoefficientBounds, HaveNoBetterPointInside) {
  const MaterialSpec spec = over_base({"ggx", {{"fresnel", "schlick"}}});
  auto form = *fit::make_form(spec, {});
  Parameter half = *form.lobes[1].colours.scale;
  half.upper = 0.5;
  form.lobes[1].colours.scale = &half;
  const fit::CoefficientBounds bounds(form, std::vector<double>{1, 1, 1});
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  int tight = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::MatrixXd J(5, 3);
    Eigen::VectorXd m(5);
    for (double& x : J.reshaped()) x = uniform(random);
    for (double& x : m) x = normal(random) + 1;
    const Eigen::VectorXd x = bounds.minimise(J.transpose() * J, J.transpose() * m);
    EXPECT_GE(x.minCoeff(), 0);
    EXPECT_LE(x[0], 1);
    EXPECT_LE(x[1] + x[2], 0.5 * (1 + 1e-9));
    tight += x[1] + x[2] > 0.4999 ? 1 : 0;
    const double best = (J * x - m).squaredNorm();
    for (int other = 0; other < 200; ++other) {
      const double scale = 0.5 * uniform(random), f0 = uniform(random);
      const Eigen::Vector3d y(uniform(random), scale * f0, scale * (1 - f0));
      EXPECT_LE(best, (J * y - m).squaredNorm() + 1e-9);
    }
  }
  EXPECT_GT(tight, 20);
}

}  // namespace
}  // namespace gonio::testing
