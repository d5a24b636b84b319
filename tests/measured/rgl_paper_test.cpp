// A real file of the RGL material database against what its material must do.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "data_folder.h"
#include "measured/pairs.h"

namespace gonio::testing {
namespace {

// Paper is nearly the same from everywhere, and what one angle of incidence says of another angle's
// direction the other says, too: two cosines and two Jacobians agree.
TEST(MeasuredFiles, RglPaperIsReciprocal) {
  const auto file = data_folder() / "rgl" / "paper_white_rgb.bsdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
  const auto pairs = read_rgl(file);
  ASSERT_TRUE(pairs.ok()) << pairs.error().message;
  // The place of incidence theta, and of the node nearest to a direction.
  const auto nearest = [&](double cos_theta_i, double x, double y, double z, double& chord) {
    std::size_t best = 0;
    chord = 4;
    for (std::size_t i = 0; i < pairs->size(); ++i) {
      if (std::abs(pairs->wi[3 * i + 2] - cos_theta_i) > 1e-9) continue;
      const double *w = &pairs->wo[3 * i], dx = w[0] - x, dy = w[1] - y, dz = w[2] - z;
      const double d = dx * dx + dy * dy + dz * dz;
      if (d < chord) chord = d, best = i;
    }
    return best;
  };
  std::map<double, bool> incidences;
  for (std::size_t i = 0; i < pairs->size(); ++i) incidences[pairs->wi[3 * i + 2]];
  int compared = 0;
  for (std::size_t i = 0; i < pairs->size(); i += 7) {
    const double *wi = &pairs->wi[3 * i], *wo = &pairs->wo[3 * i];
    for (const auto& [cosine, unused] : incidences) {
      if (std::abs(wo[2] - cosine) > 0.01 || cosine < 0.3 || wi[2] < 0.3) continue;
      // The pair turned until wo lies where that incidence has its light.
      const double length = std::hypot(wo[0], wo[1]);
      const double c = length > 0 ? wo[0] / length : 1, s = length > 0 ? wo[1] / length : 0;
      double chord = 0;
      const std::size_t other =
          nearest(cosine, c * wi[0] + s * wi[1], c * wi[1] - s * wi[0], wi[2], chord);
      if (chord > 1e-3) continue;
      EXPECT_NEAR(pairs->values[3 * other + 1], pairs->values[3 * i + 1],
                  0.06 * pairs->values[3 * i + 1]);
      ++compared;
    }
  }
  EXPECT_GT(compared, 30);
  EXPECT_NEAR(pairs->values[3 * 100 + 1], 0.28, 0.02);
}

// As many as numpy counts in the files' `rgb` below 0 where another channel is above.
TEST(MeasuredFiles, RglValuesBelowZeroAreCounted) {
  const std::map<std::string, std::size_t> expected{{"cc_ibiza_sunset_rgb.bsdf", 746},
                                                    {"cg_sunflower_rgb.bsdf", 25948},
                                                    {"paper_white_rgb.bsdf", 0},
                                                    {"satin_rosaline_rgb.bsdf", 0}};
  for (const auto& [name, raised] : expected) {
    const auto file = data_folder() / "rgl" / name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
    const auto pairs = read_rgl(file);
    ASSERT_TRUE(pairs.ok()) << pairs.error().message;
    EXPECT_EQ(pairs->raised, raised) << name;
  }
}

}  // namespace
}  // namespace gonio::testing
