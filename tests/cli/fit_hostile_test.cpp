// `gonio fit` with data that hardly are any: it fits them, or says why not, and never writes half a
// file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sstream>

#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

// theta_i, theta_o and dphi in radians.
using Reflectance = std::function<double(double, double, double)>;

// A goniometer's rows, in the angles of `gonio evaluate`.
std::string csv_of(const Reflectance& f) {
  std::ostringstream text;
  text << "theta_i,phi_i,theta_o,phi_o,f_0\n";
  for (double theta_i = 0.1; theta_i < 1.4; theta_i += 0.25) {
    for (double theta_o = 0.05; theta_o < 1.5; theta_o += 0.15) {
      for (double phi = 0; phi < 6; phi += 0.6)
        text << theta_i << ",0," << theta_o << ',' << phi << ',' << f(theta_i, theta_o, phi)
             << '\n';
    }
  }
  return text.str();
}

class HostileFit : public ::testing::Test {
 protected:
  // The tool's output for these data; status 0 and a material, or none and 1,
  // or 2 where no pair can be used.
  Finished fit(const std::string& data, const std::string& models = "phong:none,ggx:schlick") {
    const std::string folder = folder_ / "";
    write_file(folder_ / "data.csv", data);
    std::filesystem::remove(folder_ / "fit.json");
    const auto result = shell("D='" + folder + "'; gonio fit --data $D/data.csv --model " + models +
                              " --starts 3 -o $D/fit.json");
    EXPECT_THAT(result.exit_code, AnyOf(0, 1, 2)) << result.err;
    EXPECT_EQ(std::filesystem::exists(folder_ / "fit.json"), result.exit_code == 0);
    const std::string error = result.exit_code == 0 ? "" : "gonio: error: every fit failed; ";
    EXPECT_THAT(result.err, ::testing::StartsWith(error));
    EXPECT_EQ(result.err.empty(), result.exit_code == 0);
    EXPECT_THAT(result.out, Not(HasSubstr("-nan")));
    return result;
  }
  void expect_failed(const std::string& data, const std::string& reason) {
    const auto result = fit(data);
    EXPECT_EQ(result.exit_code, 2) << result.out;  // none of them has a pair to fit
    EXPECT_THAT(result.out, HasSubstr("failed"));
    EXPECT_THAT(result.out, HasSubstr(reason));
  }

  gonio::testing::TempFolder folder_;
};

TEST_F(HostileFit, ConstantDataAreADiffuseBase) {
  const auto result = fit(csv_of([](double, double, double) { return 0.1; }));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("rd 0.314"));
}

TEST_F(HostileFit, NothingReflectedIsABlackMaterial) {
  const auto result = fit(csv_of([](double, double, double) { return 0; }));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("rd 0 (at its bound)"));
  EXPECT_THAT(result.out, HasSubstr("the lobe ggx has no height: its shape is arbitrary"));
}

TEST_F(HostileFit, NothingMeasuredHasAReason) {
  expect_failed(csv_of([](double, double, double) { return -1; }), "negative or not measured");
  expect_failed(csv_of([](double, double, double) { return std::nan(""); }), "not finite");
  expect_failed("theta_i,phi_i,theta_o,phi_o,f_0\n", "0 pairs");
}

TEST_F(HostileFit, NotFiniteEntriesAreLeftOut) {
  int i = 0;
  const auto result = fit(csv_of([&](double theta_i, double, double) {
    ++i;
    if (i % 7 == 0) return std::nan("");
    return i % 11 == 0 ? HUGE_VAL : 0.1 + 0.0 * theta_i;
  }));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("not finite"));
  EXPECT_THAT(result.out, HasSubstr("rd 0.314"));
}

TEST_F(HostileFit, FivePointsAndOneDirectionSayThatTheyDoNotDetermineIt) {
  const std::string head = "theta_i,phi_i,theta_o,phi_o,f_0\n";
  std::string five = head, one = head;
  for (int i = 0; i < 5; ++i)
    five += "0.5,0," + std::to_string(0.2 * i) + ",3," + std::to_string(0.1 + 0.05 * i) + "\n";
  for (int i = 0; i < 50; ++i) one += "0.5,0,0.4,3,0.2\n";
  for (const auto& data : {five, one}) {
    const auto result = fit(data);
    EXPECT_THAT(result.out,
                AnyOf(HasSubstr("ambiguous"), HasSubstr("failed"), HasSubstr("bound-limited")));
    EXPECT_THAT(result.out, Not(HasSubstr(" converged")));
  }
}

TEST_F(HostileFit, ALobeTowardTheLightIsSaidToBeMissing) {
  const auto tape = [](double theta_i, double theta_o, double phi) {
    const double cosine = std::cos(theta_i) * std::cos(theta_o) +
                          std::sin(theta_i) * std::sin(theta_o) * std::cos(phi);
    return 0.02 + 20 * std::exp(-(1 - cosine) / 0.005);
  };
  const auto result = fit(csv_of(tape));
  EXPECT_THAT(result.out, HasSubstr("toward the light"));
}

TEST_F(HostileFit, TwoMaterialsMixedAreFittedAndJudged) {
  int i = 0;
  const auto result =
      fit(csv_of([&](double, double, double) { return ++i % 2 == 0 ? 0.3 : 0.05; }));
  EXPECT_THAT(result.out,
              AnyOf(HasSubstr("converged"), HasSubstr("ambiguous"), HasSubstr("bound-limited")));
}

}  // namespace
}  // namespace gonio::test
