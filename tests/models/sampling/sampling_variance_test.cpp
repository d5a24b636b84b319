// The variance of a sample's weight f cos(theta_o) / pdf, lost samples counting as 0: what it is at
// most, by quadrature.
#include <gtest/gtest.h>

#include "models/sampling/sampling_cases.h"
#include "models/sampling/sampling_subject.h"

namespace gonio::testing {
namespace {

struct Limit {
  std::string name;
  MaterialSpec spec;
  double theta, phi, most;
};

MaterialSpec brushed(double rd, double rs) {
  return alone("ashikhmin_shirley",
               {{"nu", number(10)}, {"nv", number(100)}, {"rd", number(rd)}, {"rs", number(rs)}});
}

std::vector<Limit> limits() {
  const MaterialSpec ggx = alone("ggx", {{"alpha_x", number(0.3)}, {"alpha_y", number(0.3)}});
  const MaterialSpec grooves = alone("cook_torrance", {{"m", number(0.3)}});
  return {{"ggx", ggx, 75, 0, 0.055},
          {"cook_torrance", grooves, 75, 0, 0.060},
          {"brushed_along_u", brushed(0, 1), 75, 0, 0.1},
          {"brushed_along_v", brushed(0, 1), 75, 90, 0.1},
          {"coated_at_10_along_u", brushed(0.5, 0.05), 10, 0, 0.15},
          {"coated_at_10_along_v", brushed(0.5, 0.05), 10, 90, 0.15},
          {"coated_at_75_along_u", brushed(0.5, 0.05), 75, 0, 0.15},
          {"coated_at_75_along_v", brushed(0.5, 0.05), 75, 90, 0.15}};
}

class Variance : public ::testing::TestWithParam<Limit> {};

TEST_P(Variance, IsAtMostWhatIsAsked) {
  const auto& [name, spec, theta, phi, most] = GetParam();
  const Direction wi = incidence(theta, phi);
  const auto subject = library_sampling<double>(spec, sampler_of(spec), best_isa());
  const auto integrands = [&](const std::vector<double>& wo) {
    const auto [pdf, f] = subject.evaluate(wi, wo);
    std::vector<double> columns;
    for (std::size_t i = 0; i < pdf.size(); ++i) {
      const double value = f[i] * wo[3 * i + 2];
      columns.insert(columns.end(), {pdf[i], value, pdf[i] > 0 ? value * (value / pdf[i]) : 0});
    }
    return columns;
  };
  const Subdivision over(wi, 3, integrands);
  const double variance = over.integral(2) - over.integral(1) * over.integral(1);
  RecordProperty("variance", std::to_string(variance));
  EXPECT_GT(variance, 0);
  EXPECT_LE(variance, most);

  // What is drawn has it, too.
  constexpr std::size_t kDrawn = 1 << 16;
  double sum = 0, squares = 0;
  for (const double w : subject.draw(wi, numbers<double>(9, kDrawn)).weights)
    sum += w, squares += w * w;
  const double mean = sum / kDrawn;
  EXPECT_NEAR(squares / kDrawn - mean * mean, variance, 0.1 * variance);
}

INSTANTIATE_TEST_SUITE_P(At, Variance, ::testing::ValuesIn(limits()),
                         [](const auto& limit) { return limit.param.name; });

}  // namespace
}  // namespace gonio::testing
