// The pictures of `gonio compare`, and the page of `gonio fit --report`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"
#include "client/support/image_files.h"
#include "measured/synthetic_merl.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kTruth =
    R"({"diffuse": {"model": "lambertian", "parameters": {"rd": [0.3, 0.1, 0.05]}},
        "specular": [{"model": "ggx", "parameters": {"f0": [0.3, 0.2, 0.1], "alpha_x": 0.15, "alpha_y": 0.15}}]})";
const std::string kOther = R"({"model": "lambertian", "parameters": {"rd": [0.9, 0.5, 0.5]}})";

// Pairs of a known material in $D/data.csv, it and another one in $D/truth.json and $D/other.json.
class Compare : public ::testing::Test {
 protected:
  void SetUp() override {
    write_file(folder_ / "truth.json", kTruth);
    write_file(folder_ / "other.json", kOther);
    const auto made =
        run("gonio evaluate --material $D/truth.json --deg --with-input --grid "
            "theta_i=30/60/80,phi_i=0,theta_o=0:85:18,phi_o=0:330:12 -o $D/data.csv");
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  [[nodiscard]] Finished run(const std::string& line) const {
    return shell("D='" + (folder_ / "").string() + "'; " + line);
  }
  [[nodiscard]] Png picture(const std::string& name) const {
    return decoded_png(content_of(folder_ / name));
  }

  gonio::testing::TempFolder folder_;
};

const std::string kCompare = "gonio compare --reference $D/data.csv --deg ";

// How many pixels have about this colour.
std::size_t count(const Png& picture, std::array<int, 3> colour) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    bool same = true;
    for (std::size_t c = 0; c < 3; ++c)
      same = same && std::abs(picture.rgb[i + c] - colour[c]) < 30;
    found += same ? 1 : 0;
  }
  return found;
}

TEST_F(Compare, DrawsDotsAndALineForEachMaterial) {
  const auto result =
      run(kCompare + "--material $D/truth.json $D/other.json --slices $D/slices.png");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("truth.json"), HasSubstr("other.json")));
  const Png slices = picture("slices.png");
  EXPECT_EQ(slices.width, 3 * 460);
  EXPECT_EQ(slices.height, 3 * 300 + 100);  // red, green, blue
  constexpr std::array kBlue = {0, 115, 178}, kOrange = {214, 94, 0};
  EXPECT_GT(count(slices, kBlue), 3000U);
  EXPECT_GT(count(slices, kOrange), 3000U);
  ASSERT_EQ(run(kCompare + "--material $D/truth.json --slices $D/one.png").exit_code, 0);
  EXPECT_LT(count(picture("one.png"), kOrange), 100U);  // but for the light's dashes
}

// Angles that are five degrees off, but for rounding, are all near enough.
TEST_F(Compare, DrawsASliceFiveDegreesAway) {
  ASSERT_EQ(run("gonio evaluate --material $D/truth.json --deg --with-input --grid "
                "theta_i=5:75:8,phi_i=0,theta_o=0:85:18,phi_o=0:330:12 -o $D/data.csv")
                .exit_code,
            0);
  const auto result = run(kCompare + "--material $D/truth.json --slices $D/slices.png");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(picture("slices.png").width, 3 * 460);
}

TEST_F(Compare, DrawsSpheresOfWhatIsMeasuredAndOfTheMaterials) {
  ASSERT_TRUE(
      gonio::testing::write_merl(folder_ / "glossy.binary", gonio::testing::glossy_example));
  const auto result = run(
      "gonio compare --reference $D/glossy.binary --material $D/other.json --slices $D/slices.png "
      "--render $D/spheres.png");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Png spheres = picture("spheres.png");
  EXPECT_EQ(spheres.width, 2 * 268 + 8);
  // The example is redder than green and greener than blue; the other material's green is its blue.
  const auto at = [&](int x, int y) {
    const auto* pixel = spheres.at(x, y);
    return std::array{int{pixel[0]}, int{pixel[1]}, int{pixel[2]}};
  };
  const auto measured = at(8 + 130, 34 + 130), other = at(8 + 268 + 130, 34 + 130);
  EXPECT_GT(measured[0], measured[1]);
  EXPECT_GT(measured[1], measured[2]);
  EXPECT_GT(other[0], other[1] + 20);
  EXPECT_NEAR(other[1], other[2], 1);
  EXPECT_NE(measured, other);
}

TEST_F(Compare, NamesWhatCannotBeDrawn) {
  const auto error_of = [&](const std::string& line) {
    const auto result = run(line);
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_THAT(result.out, IsEmpty());
    return result.err;
  };
  EXPECT_THAT(error_of(kCompare + "-m $D/truth.json --slices $D/x.jpg"),
              AllOf(HasSubstr("--slices"), HasSubstr("ends in .png")));
  EXPECT_THAT(error_of(kCompare + "-m $D/truth.json --render $D/x.png"),
              AllOf(HasSubstr("--reference"), HasSubstr("a MERL .binary")));
  std::string many;
  for (int i = 0; i < 13; ++i) many += " $D/truth.json";
  EXPECT_THAT(error_of(kCompare + "--slices $D/x.png -m" + many), HasSubstr("1 to 12"));
  write_file(folder_ / "side.csv",
             "theta_i,phi_i,theta_o,phi_o,f_0\n30,0,40,90,1\n60,0,40,90,1\n15,0,40,180,1\n");
  EXPECT_THAT(error_of("gonio compare --reference $D/side.csv --deg -m '{\"model\": "
                       "\"lambertian\"}' --slices $D/x.png"),
              HasSubstr("in the plane of incidence"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.png"));
}

TEST_F(Compare, AReportIsAlsoAPageForPeople) {
  const auto result =
      run("gonio fit --data $D/data.csv --deg --model ggx:schlick,lambertian -q --report $D/a.md "
          "--report $D/a.json");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = read_file(folder_ / "a.md");
  for (const char* word :
       {"# Fits to ", "Objective l1, strategy auto", "pairs", "## ggx:schlick: ", "| up to 80° |",
        "`specular[0].parameters.alpha_x` | all | 0.15", "95 % interval", "starts end within 1 %",
        "The worst places", "Albedo", "s of one processor", "## lambertian: "}) {
    EXPECT_THAT(page, HasSubstr(word));
  }
  EXPECT_THAT(read_file(folder_ / "a.json"), HasSubstr("\"certificate\""));
}

// A zone without pairs has no error, not one of 0.
TEST_F(Compare, APageSaysWhereThereAreNoPairs) {
  const auto result =
      run("gonio evaluate --material $D/truth.json --deg --with-input --grid "
          "theta_i=10:60:6,theta_o=0:70:8,phi_o=0:330:12 -o $D/steep.csv && "
          "gonio fit --data $D/steep.csv --deg --model lambertian -q --report $D/a.md");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = read_file(folder_ / "a.md");
  EXPECT_THAT(page, HasSubstr("| no pairs |"));
  EXPECT_THAT(page, HasSubstr("| above 80° | no pairs | - | - | - | - |"));
}

}  // namespace
}  // namespace gonio::test
