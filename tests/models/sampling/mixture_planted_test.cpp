// The checks of samplers find errors planted in how lobes are chosen and losses told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "models/harness/harness_sampling.h"
#include "models/harness/hemisphere.h"

namespace gonio::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;

using Subject = SamplingSubject<double>;

double level() { return sidak(0.01, 2 * count_of_places()); }

// Chooses the first strategy with `change` more than the share that its pdf is made with.
Subject with_lobe_probability(const Subject& right, double share, double change) {
  Subject wrong = right;
  wrong.draw = [=](const Direction& wi, std::vector<double> xi) {
    const double used = share + change;
    for (std::size_t i = 0; i < xi.size(); i += 3) {
      xi[i] =
          xi[i] < used ? xi[i] / used * share : share + (xi[i] - used) / (1 - used) * (1 - share);
    }
    return right.draw(wi, xi);
  };
  return wrong;
}

class PlantedInMixtures : public ::testing::TestWithParam<Case> {};

TEST_P(PlantedInMixtures, WrongLobeProbabilityIsFound) {
  const Place place{GetParam().name, GetParam().spec, incidence(30, 25), 3};
  const Subject right = library_sampling<double>(place.spec, sampler_of(place.spec), best_isa());
  const std::vector<double> shares = shares_of(right.sampler, place.wi[2]);
  ASSERT_GT(shares.size(), 1U) << "not a mixture";
  const Integrated integrated = integrate(right, place);
  EXPECT_THAT(check_distribution(right, place, integrated, level()), IsEmpty());
  const Subject wrong = with_lobe_probability(right, shares[0], shares[0] < 0.5 ? 0.05 : -0.05);
  const Findings found = check_distribution(wrong, place, integrated, level());
  ASSERT_THAT(found, Not(IsEmpty()));

  // The densities that it leaves differ as much.
  std::ifstream file(found[0].substr(found[0].find("see ") + 4));
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  EXPECT_EQ(line, "x,y,z,solid_angle,pdf,sampled");
  double distance = 0;
  for (double x, y, z, solid_angle, pdf, sampled; std::getline(file, line);) {
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf", &x, &y, &z, &solid_angle, &pdf,
                          &sampled),
              6);
    EXPECT_NEAR(std::hypot(x, y, z), 1, 1e-4);
    distance += std::abs(pdf - sampled) * solid_angle;
  }
  EXPECT_GT(distance, 0.05);
  EXPECT_LT(distance, 0.2);
}

std::vector<Case> mixtures() {
  const auto coated = [](double nu, double rs) {
    return alone(
        "ashikhmin_shirley",
        {{"nu", number(nu)}, {"nv", number(100)}, {"rs", number(rs)}, {"rd", number(0.5)}});
  };
  std::vector<Case> all{{"ashikhmin_shirley", Sharpness::smooth, coated(100, 0.05)},
                        {"ashikhmin_shirley_anisotropic", Sharpness::smooth, coated(1000, 0.4)}};
  for (Case& c : cases_of("sum")) {
    if (c.name == "grey base, coloured metal") all.push_back(std::move(c)), all.back().name = "sum";
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Materials, PlantedInMixtures, ::testing::ValuesIn(mixtures()),
                         [](const auto& c) { return c.param.name; });

// Samples that are lost and not told of.
TEST(PlantedInLosses, UntoldLossIsFound) {
  const Place place{"ggx", alone("ggx", {{"alpha_x", number(1)}, {"alpha_y", number(0.2)}}),
                    incidence(80, 65), 4};
  const Subject right = library_sampling<double>(place.spec, sampler_of(place.spec), best_isa());
  const Integrated integrated = integrate(right, place);
  EXPECT_GT(integrated.lost, 0.01);
  EXPECT_THAT(check_total(integrated), IsEmpty());
  Subject wrong = right;
  wrong.draw = [&](const Direction& wi, const std::vector<double>& xi) {
    Samples<double> s = right.draw(wi, xi);
    s.lost = 0;
    return s;
  };
  EXPECT_THAT(check_total(integrate(wrong, place)), Not(IsEmpty()));
  EXPECT_THAT(check_distribution(wrong, place, integrated, level()), Not(IsEmpty()));
}

}  // namespace
}  // namespace gonio::testing
