// Scattered measurements in text: real files, made ones, and what is wrong with others.
#include "measured/pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "data_folder.h"
#include "measured/temp_folder.h"

namespace gonio::testing {
namespace {

using ::testing::AllOf;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kCornell =
    "# paint\n2\n400 # nm\n 700\n\n0.5 0 0.25 1 0.5 1e-3\n0.5 0 0.25 -1 -1e-400 0.25\n";
const std::string kAlta =
    "#DIM 3 1\n#VS 0\n#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI\n0.5 0.3 0.4 0.25\n0.5 0 0 0.125\n";

std::string message(const Result<MeasuredPairs>& result) {
  return result ? "no error" : result.error().message;
}

TEST(Cornell, ReadsAnglesAndWavelengths) {
  const auto pairs = parse_cornell(kCornell, "paint");
  ASSERT_TRUE(pairs.ok()) << message(pairs);
  EXPECT_EQ(pairs->channels, 2);
  ASSERT_EQ(pairs->size(), 2U);
  EXPECT_THAT(pairs->values, ElementsAre(0.5, 1e-3, 0, 0.25));
  EXPECT_DOUBLE_EQ(pairs->wi[0], std::sin(0.5));
  EXPECT_DOUBLE_EQ(pairs->wi[2], std::cos(0.5));
  EXPECT_DOUBLE_EQ(pairs->wo[3], std::sin(0.25) * std::cos(1));
  EXPECT_DOUBLE_EQ(pairs->wo[4], -std::sin(0.25) * std::sin(1));
}

TEST(Cornell, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(message(parse_cornell("", "p")), HasSubstr("p:1: found the end of the file"));
  EXPECT_THAT(message(parse_cornell("0\n", "p")), HasSubstr("a whole number from 1 to 64"));
  EXPECT_THAT(message(parse_cornell("1e9 1\n", "p")), HasSubstr("a whole number from 1 to 64"));
  EXPECT_THAT(message(parse_cornell("nan\n", "p")), HasSubstr("a whole number from 1 to 64"));
  EXPECT_THAT(message(parse_cornell("2 400", "p")), HasSubstr("a wavelength in nm"));
  EXPECT_THAT(message(parse_cornell("1 400\n", "p")), HasSubstr("expected rows of theta_i"));
  EXPECT_THAT(message(parse_cornell("1 400\n0 0 0 0\n", "p")),
              AllOf(HasSubstr("p:2: found 4 numbers"), HasSubstr("a value for each of 1")));
  EXPECT_THAT(message(parse_cornell("1 400\n0 0 x 0 1\n", "p")), HasSubstr("p:2: found 'x'"));
}

TEST(Alta, ReadsTheProjectedAngles) {
  const auto pairs = parse_alta(kAlta, "tape");
  ASSERT_TRUE(pairs.ok()) << message(pairs);
  EXPECT_EQ(pairs->channels, 1);
  EXPECT_THAT(pairs->values, ElementsAre(0.25, 0.125));
  EXPECT_DOUBLE_EQ(pairs->wi[0], std::sin(0.5));
  EXPECT_THAT(pairs->wo, ElementsAre(DoubleNear(0.6 * std::sin(0.5), 1e-15),
                                     DoubleNear(0.8 * std::sin(0.5), 1e-15),
                                     DoubleNear(std::cos(0.5), 1e-15), 0, 0, 1));
}

TEST(Alta, TakesTheCosineOutAndMarksTheHorizon) {
  const auto pairs = parse_alta(
      "#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\r\n" + kAlta + "0.5 1.5707963267948966 0 0.5\n",
      "tape");
  ASSERT_TRUE(pairs.ok()) << message(pairs);
  EXPECT_THAT(pairs->values, ElementsAre(DoubleNear(0.25 / std::cos(0.5), 1e-15), 0.125, 0.5));
  EXPECT_EQ(pairs->wo[8], 0);
}

TEST(Alta, SaysWhatIsWrong) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kAlta;
    text.replace(text.find(from), from.size(), to);
    return message(parse_alta(text, "tape"));
  };
  EXPECT_THAT(with("#DIM 3 1", ""), HasSubstr("found no #DIM; expected #DIM 3 and the number"));
  EXPECT_THAT(with("3 1", "4 1"), HasSubstr("found #DIM 4 1"));
  EXPECT_THAT(with("3 1", "3 65"), HasSubstr("1 to 64"));
  EXPECT_THAT(with("ISOTROPIC_TL", "SCHLICK_TL"), HasSubstr("#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI"));
  EXPECT_THAT(with("#VS 0", "#VS 2"), HasSubstr("#VS 0"));
  EXPECT_THAT(with("#VS 0", "#PARAM_OUT ENERGY"), HasSubstr("INV_STERADIAN"));
  EXPECT_THAT(with("0.125", ""), HasSubstr("tape:5: found 3 numbers; expected 4: theta_i"));
}

TEST(Text, OfAFileThatCannotBeRead) {
  const TempFolder folder;
  EXPECT_EQ(read_cornell(folder / "none").error().code, ErrorCode::not_found);
  EXPECT_EQ(read_alta(folder / "").error().code, ErrorCode::invalid_argument);
}

// Whatever stands in a file: an answer with whole pairs, or an error with a message.
TEST(Text, SurvivesAnything) {
  std::mt19937 random(1);
  for (int round = 0; round < 20'000; ++round) {
    std::string text = round % 2 == 0 ? kCornell : kAlta;
    for (int i = std::uniform_int_distribution<int>(1, 4)(random); i > 0 && !text.empty(); --i) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.resize(at);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 16));
          break;
      }
    }
    for (const auto& pairs : {parse_cornell(text, "p"), parse_alta(text, "p")}) {
      if (!pairs) {
        EXPECT_FALSE(pairs.error().message.empty());
        continue;
      }
      EXPECT_EQ(pairs->wi.size(), pairs->wo.size());
      EXPECT_EQ(pairs->values.size(), pairs->size() * static_cast<std::size_t>(pairs->channels));
    }
  }
}

TEST(MeasuredFiles, CornellPaints) {
  const auto file = data_folder() / "cornell" / "garnet_red.brdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
  const auto pairs = read_cornell(file);
  ASSERT_TRUE(pairs.ok()) << message(pairs);
  EXPECT_EQ(pairs->channels, 31);
  EXPECT_EQ(pairs->size(), 1439U);
  EXPECT_DOUBLE_EQ(pairs->values[0], 0.023025);
  EXPECT_DOUBLE_EQ(pairs->wi[2], std::cos(0.872665));
  // The sum that awk finds in columns 5 to 35 of its rows.
  EXPECT_NEAR(std::accumulate(pairs->values.begin(), pairs->values.end(), 0.0), 3677.644973, 1e-6);
}

TEST(MeasuredFiles, RetroReflectingTapes) {
  struct Tape {
    const char* name;
    std::size_t rows;
  };
  for (const Tape& of : {Tape{"retro-3M-jaune.dat", 7397}, Tape{"retro-gray-tape.dat", 7405}}) {
    const auto file = data_folder() / "retro" / of.name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
    const auto pairs = read_alta(file);
    ASSERT_TRUE(pairs.ok()) << message(pairs);
    EXPECT_EQ(pairs->channels, 1);
    EXPECT_EQ(pairs->size(), of.rows);
    // On the light's side the brightest place is where the light comes from.
    double brightest = 0, cosine = -1;
    for (std::size_t i = 0; i < pairs->size(); ++i) {
      const double *wi = &pairs->wi[3 * i], *wo = &pairs->wo[3 * i];
      if (wo[0] <= 0 || wo[2] < 0.1 || pairs->values[i] < brightest) continue;
      brightest = pairs->values[i];
      cosine = wi[0] * wo[0] + wi[1] * wo[1] + wi[2] * wo[2];
    }
    EXPECT_GT(cosine, std::cos(0.2)) << of.name;
  }
}

}  // namespace
}  // namespace gonio::testing
