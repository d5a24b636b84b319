#include "select/error/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/report/metrics.h"
#include "fit/synthetic.h"
#include "select/trials.h"

namespace gonio::testing {
namespace {

using Numbers = std::vector<double>;
using select::Metric;

MaterialSpec diffuse(double rd) { return {LobeSpec{"lambertian", {{"rd", Numbers{rd}}}}, {}, {}}; }

// Blocks add up to what fit::compare says of the whole.
TEST(Error, OfBlocksIsThatOfTheWhole) {
  const fit::Data data = data_of(diffuse(0.5), scattered_pairs(3000, 1), 0.3);
  const Material material = *Material::create(diffuse(0.4));
  const fit::Errors whole = fit::compare(material, data, 0).errors.all;
  const select::Blocks blocks(data);
  EXPECT_EQ(blocks.parts.size(), 64U);
  const auto value = [&](Metric metric) {
    return bounded(errors_of(material, blocks, metric), metric, 0.95).value;
  };
  EXPECT_NEAR(value(Metric::l1), whole.l1, 1e-9);
  EXPECT_NEAR(value(Metric::rmse), whole.rmse, 1e-9);
  EXPECT_NEAR(value(Metric::log), whole.log, 1e-9);
  EXPECT_NEAR(value(Metric::cbrt), whole.cbrt, 1e-9);
}

// Of two greys that face the light: L* of 50 and 40 per cent, by the formula of CIE's lightness.
TEST(Error, OfAPictureIsOfItsColours) {
  fit::Data data = data_of(diffuse(0.5), scattered_pairs(200, 1));
  std::fill(data.wi[0].begin(), data.wi[0].end(), 0.0F);
  std::fill(data.wi[1].begin(), data.wi[1].end(), 0.0F);
  std::fill(data.wi[2].begin(), data.wi[2].end(), 1.0F);
  const Material material = *Material::create(diffuse(0.4));
  const auto l = [](double y) { return 116 * std::cbrt(y) - 16; };
  const double middle = (l(0.5) + l(0.4)) / 2 - 50, square = middle * middle;
  const double expected = (l(0.5) - l(0.4)) / (1 + 0.015 * square / std::sqrt(20 + square));
  const auto value = [&](const fit::Data& of) {
    const auto errors = errors_of(material, select::Blocks(of), Metric::delta_e);
    return bounded(errors, Metric::delta_e, 0.95).value;
  };
  EXPECT_NEAR(value(data), expected, 1e-4);
  EXPECT_GT(expected, 4);
  // Pairs count as pixels show them: half of them, without error, for 1 and the others for 0.6.
  fit::Data half = data;
  for (std::size_t i = 0; i < half.size(); ++i) {
    half.weights[i] = 1;
    half.wo[0][i] = i % 2 == 0 ? 0 : 0.8F;
    half.wo[1][i] = 0;
    half.wo[2][i] = i % 2 == 0 ? 1 : 0.6F;
    if (i % 2 == 0) half.values[i] = static_cast<float>(0.4 / std::numbers::pi);
  }
  EXPECT_NEAR(value(half), expected * 0.6 / 1.6, 1e-3);
}

// A float32 result differs from float64's, by a little more than nothing and no more than stated.
TEST(Error, OfFloat32IsWithinTheStatedBound) {
  const MaterialSpec spec{
      LobeSpec{"ggx", {{"alpha_x", Numbers{0.1}}, {"alpha_y", Numbers{0.1}}}}, {}, {}};
  const fit::Data data = data_of(spec, scattered_pairs(2000, 1));
  const Material material = *Material::create(spec);
  const double error = float32_error(material, select::Blocks(data), Metric::l1);
  EXPECT_GT(error, 1e-9);
  EXPECT_LT(error, material.error_bound(Precision::fast).relative);
}

}  // namespace
}  // namespace gonio::testing
