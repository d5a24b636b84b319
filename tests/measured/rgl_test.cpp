// Files of the RGL material database: a made one of a known reflectance, and what is wrong with
// others. A real one is in rgl_paper_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "measured/pairs.h"
#include "measured/temp_folder.h"
#include "measured/tensor_maker.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

// What the made file shows: not constant, and not the same in all channels.
double reflectance(double cos_theta_o, int channel) {
  return 0.1 * (channel + 1) + 0.3 * cos_theta_o;
}

struct MadeOf {
  std::vector<float> theta{0.2F, 0.7F, 1.1F};
  float normals = 2;  // of all nodes: the map bends nothing
  std::uint64_t channels = 3;
  std::uint8_t jacobian = 1;
};

constexpr std::uint64_t kSide = 64;

// Written from the paper's definition of what is stored: f cos(theta_o) 4 sigma / D.
std::string made(const MadeOf& of = {}) {
  const float ndf = 0.5F, sigma = 0.8F;
  std::vector<float> rgb;
  for (const float theta : of.theta) {
    for (std::uint64_t c = 0; c < of.channels; ++c) {
      for (std::uint64_t node = 0; node < kSide * kSide; ++node) {
        const double u = static_cast<double>(node % kSide) / (kSide - 1);
        const double v = static_cast<double>(node / kSide) / (kSide - 1);
        const double theta_m = u * u * kPi / 2, phi_m = (2 * v - 1) * kPi, t = theta;
        const double cosine =
            std::sin(t) * std::sin(theta_m) * std::cos(phi_m) + std::cos(t) * std::cos(theta_m);
        const double z = 2 * cosine * std::cos(theta_m) - std::cos(t);
        rgb.push_back(
            static_cast<float>(reflectance(z, static_cast<int>(c)) * z * 4 * sigma / ndf));
      }
    }
  }
  TensorMaker maker;
  const auto angles = static_cast<std::uint64_t>(of.theta.size());
  maker.add("description", 1, {4}, "made", 4);
  maker.add("phi_i", {1}, {0});
  maker.add("theta_i", {angles}, of.theta);
  maker.add("ndf", {2, 8}, std::vector<float>(16, ndf));
  maker.add("sigma", {2, 8}, std::vector<float>(16, sigma));
  maker.add("vndf", {1, angles, 4, 4}, std::vector<float>(16 * angles, of.normals));
  maker.add("rgb", {1, angles, of.channels, kSide, kSide}, rgb);
  maker.add("jacobian", 1, {1}, &of.jacobian, 1);
  return maker.bytes();
}

std::string error_of(const std::string& bytes) {
  const auto pairs = parse_rgl(bytes, "film");
  return pairs ? "no error" : pairs.error().message;
}

TEST(Rgl, GivesBackWhatWasStored) {
  const auto pairs = parse_rgl(made(), "film");
  ASSERT_TRUE(pairs.ok()) << pairs.error().message;
  EXPECT_EQ(pairs->channels, 3);
  ASSERT_EQ(pairs->size(), 3 * kSide * kSide);
  std::size_t above = 0;
  for (std::size_t i = 0; i < pairs->size(); ++i) {
    const double* wo = &pairs->wo[3 * i];
    EXPECT_NEAR(wo[0] * wo[0] + wo[1] * wo[1] + wo[2] * wo[2], 1, 1e-12);
    if (wo[2] < 0.01) continue;
    ++above;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(pairs->values[3 * i + static_cast<std::size_t>(c)], reflectance(wo[2], c), 1e-5);
  }
  EXPECT_GT(above, pairs->size() / 2);
}

// All pairs measure 4 pi^2; those of one angle the part of incidence half way to the next.
TEST(Rgl, WeighsByTheMeasureOfPairs) {
  const auto pairs = parse_rgl(made(), "film");
  ASSERT_TRUE(pairs.ok());
  double sum = 0, lit = 0;
  for (std::size_t i = 0; i < pairs->size(); ++i) {
    sum += pairs->weights[i];
    lit += pairs->weights[i] * pairs->wo[3 * i + 2];
  }
  EXPECT_NEAR(sum, 4 * kPi * kPi, 0.01 * 4 * kPi * kPi);
  EXPECT_NEAR(lit, 2 * kPi * kPi, 0.01 * 2 * kPi * kPi);
}

TEST(Rgl, ColoursOutsideOfSrgbAreCutNotLost) {
  TensorMaker maker;
  maker.add("phi_i", {1}, {0});
  maker.add("theta_i", {1}, {0.1F});
  maker.add("ndf", {2, 2}, std::vector<float>(4, 1));
  maker.add("sigma", {2, 2}, std::vector<float>(4, 1));
  maker.add("vndf", {1, 1, 2, 2}, std::vector<float>(4, 1));
  std::vector<float> rgb(27, 1);
  std::fill(rgb.begin() + 18, rgb.end(), -0.5F);  // blue
  rgb[4] = rgb[13] = -0.1F;                       // and the middle's other channels
  maker.add("rgb", {1, 1, 3, 3, 3}, rgb);
  const std::uint8_t jacobian = 0;
  maker.add("jacobian", 1, {1}, &jacobian, 1);
  const auto pairs = parse_rgl(maker.bytes(), "film");
  ASSERT_TRUE(pairs.ok()) << pairs.error().message;
  EXPECT_NEAR(pairs->values[9] * pairs->wo[11], 1, 1e-12);
  EXPECT_EQ(pairs->values[11], 0);
  EXPECT_LT(pairs->values[12], 0);
  EXPECT_LT(pairs->values[14], 0);
  EXPECT_EQ(pairs->raised, 8U);  // blue of all nodes but the middle's, whose colour stays as it is
}

TEST(Rgl, SaysWhatIsWrong) {
  const std::string good = made();
  EXPECT_THAT(error_of("tensor_file"), HasSubstr("film: found 'tensor_file' at its beginning"));
  EXPECT_THAT(error_of(good.substr(0, 15)), HasSubstr("its end after the first bytes"));
  EXPECT_THAT(error_of(good.substr(0, 40)), HasSubstr("its end within the list of fields"));
  EXPECT_THAT(error_of(good.substr(0, good.size() - 2)), HasSubstr("beyond the file's end"));
  const auto renamed = [&](const std::string& field, const std::string& to) {
    std::string bytes = good;
    return error_of(bytes.replace(bytes.find(field), field.size(), to));
  };
  EXPECT_THAT(renamed("theta_i", "gamma_i"), HasSubstr("no field 'theta_i'"));
  EXPECT_THAT(renamed("rgb", "RGB"), HasSubstr("no field 'rgb'"));
  MadeOf of;
  of.theta = {0.7F, 0.2F};
  EXPECT_THAT(error_of(made(of)), HasSubstr("'theta_i' that do not rise"));
  of = {};
  of.channels = 4;
  EXPECT_THAT(error_of(made(of)), HasSubstr("4 channels"));
  of = {};
  of.normals = -1;
  EXPECT_THAT(error_of(made(of)), HasSubstr("a density that is negative"));
  const TempFolder folder;
  EXPECT_EQ(read_rgl(folder / "none").error().code, ErrorCode::not_found);
}

// Whatever stands in a file: an answer with whole pairs, or an error with a message.
TEST(Rgl, SurvivesAnything) {
  const std::string good = made();
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    std::string bytes = good;
    // The list of fields, and now and then the numbers.
    const std::size_t reach = round % 4 == 0 ? bytes.size() : 330;
    for (int i = 0; i < 3; ++i) bytes[random() % reach] = static_cast<char>(random());
    if (round % 3 == 0) bytes.resize(random() % bytes.size());
    const auto pairs = parse_rgl(bytes, "film");
    if (!pairs) {
      EXPECT_FALSE(pairs.error().message.empty());
      continue;
    }
    EXPECT_EQ(pairs->wi.size(), pairs->wo.size());
    EXPECT_EQ(pairs->values.size(), 3 * pairs->size());
    EXPECT_EQ(pairs->weights.size(), pairs->size());
  }
}

}  // namespace
}  // namespace gonio::testing
