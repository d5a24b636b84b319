// Times of repetitions, and work timed against other work.
#include "timing/race.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "timing/pairs.h"

namespace gonio::timing {
namespace {

// Some steps that no compiler leaves out.
void work(int steps) {
  volatile double x = 1;
  for (int i = 0; i < steps; ++i) x = std::sqrt(x + 1);
}

TEST(Spread, IsTheBestAndTheQuartiles) {
  const std::array times{5.0, 1.0, 4.0, 2.0, 3.0};
  const Spread spread = spread_of(times);
  EXPECT_EQ(spread.best, 1);
  EXPECT_EQ(spread.lower, 2);
  EXPECT_EQ(spread.median, 3);
  EXPECT_EQ(spread.upper, 4);
  EXPECT_EQ(spread.repetitions, 5);
  const std::array two{2.0, 4.0};
  EXPECT_EQ(spread_of(two).median, 3);
  EXPECT_EQ(spread_of({}).repetitions, 0);
  EXPECT_EQ(scaled(spread, 1000).upper, 4000);
}

TEST(Race, FindsWhatTakesLonger) {
  const std::array runners{Runner{[] { work(1000); }, 1}, Runner{[] { work(4000); }, 1},
                           Runner{[] { work(4000); }, 4}};
  const auto times = race(runners, {.repetitions = 9, .seconds = 0.001});
  ASSERT_EQ(times.size(), 3);
  for (const Spread& spread : times) EXPECT_EQ(spread.repetitions, 9);
  EXPECT_NEAR(times[1].best / times[0].best, 4, 1);
  EXPECT_NEAR(times[2].best / times[0].best, 1, 0.25);  // by item
}

TEST(Race, RepetitionsAreLongEnoughAndTakeTurns) {
  std::vector<int> order;
  const auto note = [&](int who) {
    return Runner{[&order, who] {
                    if (order.empty() || order.back() != who) order.push_back(who);
                    work(20'000);
                  },
                  1};
  };
  const std::array runners{note(0), note(1), note(2)};
  const double start = now(Clock::thread);
  (void)race(runners, {.repetitions = 20, .seconds = 0.001});
  EXPECT_GE(now(Clock::thread) - start, 0.9 * 20 * 3 * 0.001);
  // Each of 20 rounds changes at least twice between the three.
  EXPECT_GE(order.size(), 40);
}

TEST(Race, StopsWhenAsked) {
  int asked = 0;
  const std::array runners{Runner{[] { work(100); }, 1}, Runner{[] { work(100); }, 1}};
  const auto times =
      race(runners, {.repetitions = 1000, .seconds = 1e-5}, [&] { return ++asked > 10; });
  ASSERT_EQ(times.size(), 2);
  EXPECT_LE(times[0].repetitions + times[1].repetitions, 10);
}

TEST(Pairs, AreEvaluatedInBothPrecisions) {
  const auto pairs = std::make_shared<Pairs>(100);
  const auto material = Material::create(
      {.model = LobeSpec{"lambertian", {{"rd", std::vector<double>{0.1, 0.2, 0.3}}}},
       .diffuse = {},
       .specular = {}});
  ASSERT_TRUE(material);
  const Runner fast = evaluation(pairs, *material, Precision::fast, best_isa());
  EXPECT_EQ(fast.items, 100);
  fast.run();
  evaluation(pairs, *material, Precision::reference, best_isa()).run();
  constexpr double kPi = std::numbers::pi;
  for (std::size_t i = 0; i < 300; ++i) {
    const double wanted = (1.0 + static_cast<double>(i / 100)) / 10 / kPi;
    EXPECT_NEAR(pairs->fast().values.data[i], wanted, 1e-7);
    EXPECT_NEAR(pairs->reference().values.data[i], wanted, 1e-14);
  }
}

}  // namespace
}  // namespace gonio::timing
