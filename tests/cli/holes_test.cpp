// What a table has not measured shows wherever it is used: assess, albedo, evaluate, render, fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"
#include "measured/synthetic_merl.h"

namespace gonio::test {
namespace {

using gonio::testing::Rgb;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kDegree = std::numbers::pi / 180;

// A broad lobe. `masked`: light and view within a degree of the normal are, as the database's
// compact form has it. `outlier`: a cell of 1e30.
class Tables : public ::testing::Test {
 protected:
  std::string write(const std::string& name, bool masked, double outlier = 0) {
    std::string file = folder_ / (name + ".binary");
    bool placed = false;
    const bool written = gonio::testing::write_merl(file, [&](double h, double d, double p) -> Rgb {
      const double across = std::sin(h) * std::sin(d) * std::cos(p),
                   along = std::cos(h) * std::cos(d);
      if (std::abs(across) >= along) return {-1, -1, -1};
      if (masked && along + std::abs(across) > std::cos(kDegree)) return {0, 0, 0};
      const bool here = outlier > 0 && h > 0.5 && d > 0.5 && p > 0.5;
      if (here && !placed) {
        placed = true;
        return {outlier, 0.1, 0.1};
      }
      const double f = 0.05 + 0.5 * std::exp(-h * h / 0.1);
      return {f, f, f};
    });
    EXPECT_TRUE(written);
    return file;
  }
  gonio::testing::TempFolder folder_;
};

TEST_F(Tables, AssessSaysHoles) {
  const auto good = shell("gonio assess --pairs 20 -m " + write("good", false));
  EXPECT_EQ(good.exit_code, 0) << good.out;
  EXPECT_THAT(good.out, AllOf(HasSubstr("missing_region"), HasSubstr("verdict: passed")));
  const std::string file = write("masked", true);
  const auto bad = shell("gonio assess --pairs 20 -m " + file);
  EXPECT_EQ(bad.exit_code, 4);
  EXPECT_THAT(bad.out, HasSubstr("verdict: failed (holes)"));
  const auto allowed = shell("gonio assess --pairs 20 --max-holes 0.1 -m " + file);
  EXPECT_EQ(allowed.exit_code, 0) << allowed.out;
  EXPECT_THAT(shell("gonio assess --max-zeros 2 -m " + file).err,
              HasSubstr("limits.zeros is 2; allowed: 0 to 1"));
}

TEST_F(Tables, AlbedoEvaluateAndRenderSayHoles) {
  const std::string file = write("masked", true);
  const auto albedo = shell("gonio albedo --theta 0,40 -m " + file);
  EXPECT_EQ(albedo.exit_code, 0) << albedo.err;
  EXPECT_THAT(albedo.out, AllOf(HasSubstr("lost     holes\n"), HasSubstr("has not measured")));
  const auto pair = shell(
      "printf 'wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\\n0,0,1,0.6,0,0.8\\n0.6,0,0.8,0,0.6,0.8\\n' | "
      "gonio evaluate --with-input -m " +
      file + " --pairs -");
  EXPECT_EQ(pair.exit_code, 0) << pair.err;
  EXPECT_THAT(pair.err, HasSubstr("1 of 2 pairs (50 %) met holes of the table"));
  EXPECT_THAT(pair.out, AllOf(HasSubstr(",128\n"), HasSubstr(",0\n")));
  const auto picture = shell("gonio render --size 24x24 --spp 4 -m " + file + " -o " +
                             std::string(folder_ / "p.png"));
  EXPECT_EQ(picture.exit_code, 0) << picture.err;
  EXPECT_THAT(picture.err, HasSubstr("met holes of the table"));
  const std::string good = write("good", false);
  EXPECT_THAT(shell("gonio albedo --theta 0,40 -m " + good).out, Not(HasSubstr("holes")));
}

TEST_F(Tables, FitAndAssessSayOutliers) {
  const std::string file = write("outlier", false, 1e30);
  EXPECT_THAT(shell("gonio assess --pairs 20 -m " + file).out,
              AllOf(HasSubstr("outlier"), HasSubstr("extreme"), HasSubstr("verdict: failed (")));
  const auto fit = shell("gonio fit --data " + file + " --model lambertian");
  EXPECT_THAT(fit.out + fit.err, AllOf(Not(HasSubstr("converged")), HasSubstr("far out: 1e+30")));
}

}  // namespace
}  // namespace gonio::test
