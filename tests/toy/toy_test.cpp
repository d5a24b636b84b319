// A model that the rest of gonio has never heard of, in the core: values, their error, derivatives,
// samples, fits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/material/derivative.h"
#include "engine/truth/truth.h"
#include "fit/fit.h"
#include "fit/synthetic.h"
#include "gonio/engine/evaluate.h"
#include "gonio/engine/registry.h"
#include "gonio/engine/sampler.h"

namespace gonio::testing {
namespace {

using Numbers = std::vector<double>;

const MaterialSpec kToy{
    LobeSpec{"toy", {{"w", Numbers{0.6, 0.3, 0.1}}, {"q", Numbers{0.2}}}}, {}, {}};
const MaterialSpec kForm{LobeSpec{"toy", {}}, {}, {}};

double printed(double w, double q, const std::array<double, 3>& wi,
               const std::array<double, 3>& wo) {
  const double h2 =
      std::pow(wi[0] + wo[0], 2) + std::pow(wi[1] + wo[1], 2) + std::pow(wi[2] + wo[2], 2);
  const double t = h2 / 4;
  return w / std::numbers::pi * t / (q + (1 - q) * t);
}

TEST(Toy, IsInTheRegistry) {
  ASSERT_TRUE(find_model("toy").ok());
  EXPECT_EQ(models().back().name, "toy");
  EXPECT_TRUE(find_model("ggx").ok());
}

TEST(Toy, HasTheValuesOfItsFormula) {
  const auto material = Material::create(kToy);
  ASSERT_TRUE(material.ok()) << material.error().message;
  const auto [wi, wo, weights] = scattered_pairs(4001, 1);
  const std::size_t count = weights.size();
  for (const Isa isa : supported_isas()) {
    std::vector<double> f(3 * count);
    evaluate(*material,
             Batch<double, double>{Directions<double>::interleaved(wi.data()),
                                   Directions<double>::interleaved(wo.data()), count,
                                   Values<double>::interleaved(f.data(), 3), nullptr},
             isa);
    for (std::size_t i = 0; i < count; ++i) {
      const double expected = printed(0.3, 0.2, {wi[3 * i], wi[3 * i + 1], wi[3 * i + 2]},
                                      {wo[3 * i], wo[3 * i + 1], wo[3 * i + 2]});
      ASSERT_NEAR(f[3 * i + 1], expected, 1e-6 * expected + 1e-12);
    }
  }
}

TEST(Toy, HasATruthAndADerivative) {
  const auto material = Material::create(kToy);
  const std::array<double, 3> wi{0.6, 0, 0.8}, wo{0, 0.6, 0.8};
  std::array<long double, 3> f{};
  Truth(*material).evaluate(wi, wo, f);
  EXPECT_NEAR(static_cast<double>(f[0]), printed(0.6, 0.2, wi, wo), 1e-15);

  const auto slope = MaterialDerivative::create(kToy, "parameters.q");
  ASSERT_TRUE(slope.ok()) << slope.error().message;
  std::array<double, 3> df{};
  slope->evaluate(Batch<double, double>{Directions<double>::interleaved(wi.data()),
                                        Directions<double>::interleaved(wo.data()), 1,
                                        Values<double>::interleaved(df.data(), 3), nullptr},
                  Isa::baseline);
  constexpr double kStep = 1e-6;
  const double difference =
      (printed(0.6, 0.2 + kStep, wi, wo) - printed(0.6, 0.2 - kStep, wi, wo)) / (2 * kStep);
  EXPECT_NEAR(df[0], difference, 1e-6);
}

TEST(Toy, FitsItsOwnValues) {
  const fit::Data data = data_of(kToy, scattered_pairs(500, 1));
  for (const auto& form :
       {kForm, MaterialSpec{{}, LobeSpec{"lambertian", {}}, {LobeSpec{"toy", {}}}}}) {
    const auto result = fit::fit(data, form, {});
    ASSERT_TRUE(result.ok()) << result.error().message;
    EXPECT_LT(result->certificate.errors.all.l1, 5e-4) << result->certificate.reason;
  }
  const auto alone = fit::fit(data, kForm, {});
  const auto& fitted = alone->material.model->parameters;
  EXPECT_NEAR(std::get<Numbers>(fitted.at("q"))[0], 0.2, 1e-3);
  EXPECT_NEAR(std::get<Numbers>(fitted.at("w"))[2], 0.1, 1e-3);
}

}  // namespace
}  // namespace gonio::testing
