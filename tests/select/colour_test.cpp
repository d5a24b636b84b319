// Differences of colour against pairs published with the formula, and what a picture shows.
#include "select/error/colour.h"

#include <gtest/gtest.h>

namespace gonio::testing {
namespace {

using select::Lab;

struct Case {
  Lab x, y;
  double difference;
};

// Of Sharma, Wu and Dalal 2005, "The CIEDE2000 Color-Difference Formula", table 1: hues on both
// sides of a turn, greys, blues where the ellipses tilt, and colours far apart.
TEST(DeltaE, AgreesWithPublishedPairs) {
  const Case cases[] = {{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
                        {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
                        {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
                        {{50, 0, 0}, {50, -1, 2}, 2.3669},
                        {{50, 2.49, -0.001}, {50, -2.49, 0.0009}, 7.1792},
                        {{50, 2.49, -0.001}, {50, -2.49, 0.0011}, 7.2195},
                        {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
                        {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
                        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                        {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
                        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};
  for (const Case& c : cases) {
    EXPECT_NEAR(select::delta_e(c.x, c.y), c.difference, 5e-5);
    EXPECT_NEAR(select::delta_e(c.y, c.x), c.difference, 5e-5);
    EXPECT_EQ(select::delta_e(c.x, c.x), 0);
  }
}

TEST(Lab, OfWhiteBlackAndRed) {
  const Lab white = select::lab_of(1, 1, 1), black = select::lab_of(0, 0, 0),
            red = select::lab_of(1, 0, 0);
  EXPECT_NEAR(white.l, 100, 1e-9);
  EXPECT_NEAR(white.a, 0, 1e-9);
  EXPECT_NEAR(white.b, 0, 1e-9);
  EXPECT_NEAR(black.l, 0, 1e-9);
  EXPECT_NEAR(red.l, 53.24, 0.01);
  EXPECT_NEAR(red.a, 80.09, 0.02);
  EXPECT_NEAR(red.b, 67.20, 0.03);
}

TEST(Lab, ShowsNothingBrighterThanWhite) {
  EXPECT_EQ(select::delta_e(select::lab_of(7, 3, 2), select::lab_of(1, 1, 1)), 0);
  EXPECT_EQ(select::delta_e(select::lab_of(-1, -1, -1), select::lab_of(0, 0, 0)), 0);
}

}  // namespace
}  // namespace gonio::testing
