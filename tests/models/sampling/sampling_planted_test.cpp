// The checks of samplers find what they are there to find: errors planted in samplers of every
// model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "models/harness/harness_sampling.h"
#include "models/harness/hemisphere.h"

namespace gonio::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;

using Subject = SamplingSubject<double>;

double level() { return sidak(0.01, 2 * count_of_places()); }

// The first place of a model whose lobe differs along the tangents, at 60 degrees.
Place place_of(const std::string& model) {
  for (const Place& place : places_of(model)) {
    if (place.name.starts_with("anisotropic") && place.name.find(" 60.") != std::string::npos)
      return place;
  }
  throw std::out_of_range("no such place of " + model);
}

// A sampler that takes the pdf for `factor` of (wi, wo) times what it is.
template <class Factor>
Subject with_pdf(const Subject& right, const Factor& factor) {
  Subject wrong = right;
  const auto at = [=](const Direction& wi, const std::vector<double>& wo, std::size_t i) {
    return factor(wi, Direction{wo[3 * i], wo[3 * i + 1], wo[3 * i + 2]});
  };
  wrong.draw = [=](const Direction& wi, const std::vector<double>& xi) {
    Samples<double> s = right.draw(wi, xi);
    for (std::size_t i = 0; i < s.pdf.size(); ++i) s.pdf[i] *= at(wi, s.wo, i);
    for (std::size_t i = 0; i < s.weights.size(); ++i)
      s.weights[i] /= at(wi, s.wo, i / right.channels);
    return s;
  };
  wrong.evaluate = [=](const Direction& wi, const std::vector<double>& wo) {
    Densities<double> d = right.evaluate(wi, wo);
    for (std::size_t i = 0; i < d.pdf.size(); ++i) d.pdf[i] *= at(wi, wo, i);
    return d;
  };
  return wrong;
}

class PlantedInSampling : public ::testing::TestWithParam<std::string> {
 protected:
  const Place place_ = place_of(GetParam());
  const Subject right_ = library_sampling<double>(place_.spec, sampler_of(place_.spec), best_isa());
};

TEST_P(PlantedInSampling, NothingIsFoundWhereNothingIsWrong) {
  const Integrated integrated = integrate(right_, place_);
  EXPECT_THAT(check_total(integrated), IsEmpty());
  EXPECT_THAT(check_distribution(right_, place_, integrated, level()), IsEmpty());
  EXPECT_THAT(check_albedo(right_, place_, integrated), IsEmpty());
  EXPECT_THAT(check_samples(right_, place_, best_isa()), IsEmpty());
}

TEST_P(PlantedInSampling, ScaledPdfIsFound) {
  const Subject wrong = with_pdf(right_, [](const auto&, const auto&) { return 1.02; });
  const Integrated integrated = integrate(wrong, place_);
  EXPECT_THAT(check_total(integrated), Not(IsEmpty()));
  EXPECT_THAT(check_samples(wrong, place_, best_isa()), Not(IsEmpty()));
  // The weights' own spread hides two percent from an albedo where a lobe is wide.
  const Subject worse = with_pdf(right_, [](const auto&, const auto&) { return 1.1; });
  EXPECT_THAT(check_albedo(worse, place_, integrate(worse, place_)), Not(IsEmpty()));
}

// The density of the half-vector in the place of wo's, without 1/(4 h.wi).
TEST_P(PlantedInSampling, MissingJacobianIsFound) {
  const Subject wrong = with_pdf(right_, [](const Direction& wi, const Direction& wo) {
    return 2 * std::hypot(wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]);
  });
  const Integrated integrated = integrate(wrong, place_);
  EXPECT_THAT(check_total(integrated), Not(IsEmpty()));
  EXPECT_THAT(check_distribution(wrong, place_, integrated, level()), Not(IsEmpty()));
  EXPECT_THAT(check_albedo(wrong, place_, integrated), Not(IsEmpty()));
  EXPECT_THAT(check_samples(wrong, place_, best_isa()), Not(IsEmpty()));
}

// f in the place of f cos(theta_o).
TEST_P(PlantedInSampling, WeightWithoutCosineIsFound) {
  Subject wrong = right_;
  wrong.draw = [this](const Direction& wi, const std::vector<double>& xi) {
    Samples<double> s = right_.draw(wi, xi);
    for (std::size_t i = 0; i < s.weights.size(); ++i)
      s.weights[i] /= s.wo[3 * (i / right_.channels) + 2];
    return s;
  };
  EXPECT_THAT(check_albedo(wrong, place_, integrate(right_, place_)), Not(IsEmpty()));
  EXPECT_THAT(check_samples(wrong, place_, best_isa()), Not(IsEmpty()));
}

// A pdf that is that of another direction than the one returned.
TEST_P(PlantedInSampling, OtherPdfThanThatOfEvaluationIsFound) {
  Subject wrong = right_;
  wrong.draw = [this](const Direction& wi, const std::vector<double>& xi) {
    Samples<double> s = right_.draw(wi, xi);
    for (double& pdf : s.pdf) pdf = std::nextafter(pdf, 0);
    return s;
  };
  EXPECT_THAT(check_samples(wrong, place_, best_isa()), Not(IsEmpty()));
}

INSTANTIATE_TEST_SUITE_P(Models, PlantedInSampling, ::testing::ValuesIn(analytic_models()),
                         [](const auto& name) { return name.param; });

TEST(ChiSquare, GivesTheTablesProbabilities) {
  // 5 % and 0.1 % of 1, 10 and 100 degrees of freedom: Abramowitz & Stegun, table 26.8.
  EXPECT_NEAR(upper_gamma(0.5, 3.841459 / 2), 0.05, 1e-6);
  EXPECT_NEAR(upper_gamma(5, 18.307038 / 2), 0.05, 1e-6);
  EXPECT_NEAR(upper_gamma(50, 124.34211 / 2), 0.05, 1e-6);
  EXPECT_NEAR(upper_gamma(50, 149.44925 / 2), 0.001, 1e-7);
  EXPECT_NEAR(upper_gamma(5, 3.940299 / 2), 0.95, 1e-6);
}

TEST(ChiSquare, TakesBinsOfFewTogether) {
  EXPECT_NEAR(chi_square_probability({50, 50}, {50, 50}), 1, 1e-12);
  EXPECT_NEAR(chi_square_probability({50, 50}, {60, 40}), upper_gamma(0.5, 2), 1e-12);
  EXPECT_NEAR(chi_square_probability({96, 2, 2, 1.5, 0}, {96, 5.5, 0, 0, 0}), 1, 1e-12);
  EXPECT_LT(chi_square_probability({100, 0}, {100, 30}), 1e-20);
}

}  // namespace
}  // namespace gonio::testing
