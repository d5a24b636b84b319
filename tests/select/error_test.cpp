#include "select/error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/metrics.h"
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
