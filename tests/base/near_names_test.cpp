#include "base/near_names.h"

#include <gtest/gtest.h>

#include <vector>

namespace gonio {
namespace {

const std::vector<std::string> kNames = {"aluminium", "brushed-metal", "copper", "gold",
                                         "old-gold",  "paper",         "silver"};

TEST(NearNames, ListsWhatIsAlikeBestFirst) {
  EXPECT_EQ(near_names("glod", kNames), "gold");
  EXPECT_EQ(near_names("Gold", kNames), "gold, old-gold");
  EXPECT_EQ(near_names("brushed", kNames), "brushed-metal");
  EXPECT_EQ(near_names("aluminum", kNames), "aluminium");
}

TEST(NearNames, ListsTheFirstWhereNothingIsAlike) {
  EXPECT_EQ(near_names("xyzzyx", kNames),
            "aluminium, brushed-metal, copper, gold, old-gold and 2 more");
  EXPECT_EQ(near_names("zzzzz", std::vector<std::string>{"gold"}), "gold");
  EXPECT_EQ(near_names("gold", std::vector<std::string>{}), "none");
}

using Words = std::vector<std::string_view>;

TEST(NearestName, IgnoresCaseAndSeparatorsAndTakesExchangesAsOneEdit) {
  const Words words = {"ggx", "cook_torrance", "schlick", "copper", "f0", "k", "--material"};
  const auto nearest = [&](std::string_view name) {
    return nearest_name(name, std::span<const std::string_view>(words)).value_or("");
  };
  EXPECT_EQ(nearest("GGX"), "ggx");
  EXPECT_EQ(nearest("Cook-Torrance"), "cook_torrance");
  EXPECT_EQ(nearest("cooktorrance"), "cook_torrance");
  EXPECT_EQ(nearest("shlick"), "schlick");
  EXPECT_EQ(nearest("scihlck"), "schlick");
  EXPECT_EQ(nearest("coper"), "copper");
  EXPECT_EQ(nearest("--materal"), "--material");
  EXPECT_EQ(nearest("fo"), "f0");
  EXPECT_EQ(nearest("xyz"), "");
  EXPECT_EQ(nearest("x"), "");  // another character is no likeness
  EXPECT_EQ(nearest(""), "");
}

TEST(NearestName, OfEquallyNearOnesTheLengthDecidesAndThenTheOrder) {
  const Words words = {"alpha_xx", "alpha_y", "alpha_x"};
  EXPECT_EQ(nearest_name("alpha_z", std::span<const std::string_view>(words)), "alpha_y");
}

TEST(UnknownWord, ListsAllAndAsksForTheNearest) {
  const Words words = {"linear", "nearest"};
  const Error error = unknown_word("interpolation", "neerest", words);
  EXPECT_EQ(error.message,
            "interpolation is \"neerest\"; allowed: linear, nearest; did you mean \"nearest\"?");
  EXPECT_EQ(unknown_word("interpolation", "cubic", words).allowed, "linear, nearest");
}

TEST(NearNames, HugeNamesAreCutNotCompared) {
  EXPECT_EQ(near_names(std::string(10'000'000, 'g'), std::vector<std::string>{"gold"}), "gold");
}

}  // namespace
}  // namespace gonio
