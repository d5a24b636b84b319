// Pairs to time with: those of the same count are the same, and every one is evaluated.
#include "timing/pairs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gonio::timing {
namespace {

TEST(TimedPairs, OfEveryCountAreUnitAndAboveTheHorizon) {
  for (const std::size_t count : {1U, 2U, 3U, 5U, 4001U}) {
    const Pairs pairs(count), again(count);
    ASSERT_EQ(pairs.count(), count);
    for (std::size_t i = 0; i < count; ++i) {
      for (const std::size_t w : {0U, 3U}) {
        const float x = pairs.component(w)[i], y = pairs.component(w + 1)[i],
                    z = pairs.component(w + 2)[i];
        EXPECT_NEAR(std::hypot(x, y, z), 1, 1e-6);
        EXPECT_GE(z, 0.001F * (1 - 1e-6F));
        EXPECT_EQ(x, again.component(w)[i]);
      }
    }
  }
}

TEST(TimedPairs, AreAllEvaluated) {
  const auto white = *Material::create({LobeSpec{"lambertian", {}}, {}, {}});
  for (const std::size_t count : {1U, 2U, 3U, 5U, 4001U}) {
    Pairs pairs(count, 1);
    const auto batch = pairs.fast();
    EXPECT_EQ(evaluate(white, batch, best_isa()), 0);
    const auto& values = batch.values;
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_FLOAT_EQ(values.data[static_cast<std::ptrdiff_t>(i) * values.pair_stride],
                      0.5F / 3.14159265F);
  }
}

}  // namespace
}  // namespace gonio::timing
