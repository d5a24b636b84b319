#include "base/text/join.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {
namespace {

TEST(Joined, PutsTheSeparatorBetweenWordsOnly) {
  const std::vector<std::string> none, one{"gold"}, three{"gold", "silver", "copper"};
  EXPECT_EQ(joined(none), "");
  EXPECT_EQ(joined(one), "gold");
  EXPECT_EQ(joined(three), "gold, silver, copper");
  EXPECT_EQ(joined(three, " or "), "gold or silver or copper");
  EXPECT_EQ(joined(three, ""), "goldsilvercopper");
}

TEST(Joined, CountsEmptyWords) {
  EXPECT_EQ(joined(std::vector<std::string>{"", "b", ""}, ";"), ";b;");
}

TEST(Joined, TakesAnyRangeOfWords) {
  using namespace std::string_view_literals;
  constexpr std::array kViews{"a"sv, "b"sv};
  EXPECT_EQ(joined(kViews), "a, b");
  EXPECT_EQ(joined(std::span(kViews).first(1)), "a");
  EXPECT_EQ(joined(std::set<std::string>{"b", "a"}), "a, b");
  const char* const pointers[] = {"x", "y"};
  EXPECT_EQ(joined(pointers, "|"), "x|y");
}

}  // namespace
}  // namespace gonio
