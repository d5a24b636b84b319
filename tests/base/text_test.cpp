// Pieces that all readers of text share: how it is encoded, its lines, its numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/text/encoding.h"
#include "base/text/lines.h"
#include "base/text/number.h"

namespace gonio {
namespace {

using namespace std::string_literals;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  LineReader reader(text);
  while (const auto line = reader.next()) lines.emplace_back(*line);
  return lines;
}

TEST(Lines, EndInLineFeedReturnOrBoth) {
  EXPECT_THAT(lines_in("a\nb\n"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_in("a\rb\r"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_in("a\r\nb\r\n"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_in("a\rb\nc\r\nd"), ElementsAre("a", "b", "c", "d"));
  EXPECT_THAT(lines_in("\n\r\r\n\nend"), ElementsAre("", "", "", "", "end"));
  EXPECT_TRUE(lines_in("").empty());
}

TEST(Lines, AreCounted) {
  LineReader reader("a\r\n\rb\n");
  std::vector<std::size_t> numbers;
  while (reader.next()) numbers.push_back(reader.number());
  EXPECT_THAT(numbers, ElementsAre(1, 2, 3));
  EXPECT_EQ(reader.number(), 4U);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.number(), 4U);
}

// Against a search byte by byte: every place of an end in texts of every length up to 40, from
// every place on, among bytes that differ from it by one bit.
TEST(Lines, FirstEndIsFoundWhereverItStands) {
  for (std::size_t length = 0; length <= 40; ++length) {
    for (const char fill : {'\x0b', '\x0c', '\x8a', '\x8d', '\t', '\0', 'x', '\xff'}) {
      for (std::size_t at = 0; at <= length; ++at) {
        std::string text(length, fill);
        if (at < length) text[at] = length % 2 == 0 ? '\n' : '\r';
        for (std::size_t from = 0; from <= length; ++from) {
          ASSERT_EQ(find_line_end(text, from), text.find_first_of("\r\n", from));
        }
      }
    }
  }
}

TEST(Encoding, MarkOfUtf8IsTakenOff) {
  EXPECT_EQ(*utf8_text("\xEF\xBB\xBF"
                       "31\n",
                       "p"),
            "31\n");
  EXPECT_EQ(*utf8_text("31\n", "p"), "31\n");
  EXPECT_EQ(*utf8_text("", "p"), "");
  EXPECT_EQ(*utf8_text("\xEF\xBB", "p"), "\xEF\xBB");
}

TEST(Encoding, OthersAreRefusedByName) {
  for (const auto& text : {"\xFF\xFE\x33\0"s, "\xFE\xFF\0\x33"s, "3\0001\0"s, "\0003\0001"s}) {
    const auto result = utf8_text(text, "paint.brdf");
    ASSERT_FALSE(result.ok());
    EXPECT_THAT(result.error().message,
                AllOf(HasSubstr("paint.brdf is UTF-16 text"), HasSubstr("save it as UTF-8")));
  }
  for (const auto& text :
       {"\xFF\xFE\0\0\x33\0\0\0"s, "\0\0\xFE\xFF\0\0\0\x33"s, "3\0\0\0"s, "\0\0\0003"s}) {
    const auto result = utf8_text(text, "paint.brdf");
    ASSERT_FALSE(result.ok());
    EXPECT_THAT(result.error().message, HasSubstr("UTF-32 text"));
  }
}

TEST(Number, AllOfATextOrNone) {
  const auto number = [](const char* text) { return parse_number<double>(text); };
  EXPECT_EQ(number("0.5"), 0.5);
  EXPECT_EQ(number("+0.5"), 0.5);
  EXPECT_EQ(number("-.5e1"), -5);
  EXPECT_EQ(number("1."), 1);
  EXPECT_EQ(number("1.0D-01"), 0.1);
  EXPECT_EQ(number("+2.5d+02"), 250);
  EXPECT_EQ(parse_number<float>("1.0D-01"), 0.1F);
  EXPECT_EQ(number("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(number("-Infinity"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(*number("NaN")));
  for (const char* none : {"",
                           "+",
                           "-",
                           "+-1",
                           "++1",
                           "1x",
                           "1e",
                           "1D",
                           "1e5d3",
                           "1dd3",
                           "0x10",
                           "0,5",
                           "1_000",
                           "NA",
                           "infd3",
                           "1.#INF",
                           "1 2",
                           " 1",
                           "1 ",
                           "'0'",
                           "\xE2\x88\x92"
                           "1"}) {
    EXPECT_FALSE(number(none)) << none;
  }
}

TEST(Number, OutOfRange) {
  EXPECT_EQ(parse_number<double>("1e400"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number<double>("-1D+400"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number<double>("1e-400"), 0);
  EXPECT_EQ(parse_number<double>("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(parse_number<float>("1e39"), std::numeric_limits<float>::infinity());
  EXPECT_EQ(parse_number<float>("1D-60"), 0);
  EXPECT_EQ(parse_number<float>("1.4e-45"), std::numeric_limits<float>::denorm_min());
}

TEST(Number, HintsSayWhyTextIsNone) {
  EXPECT_THAT(number_hint("0,5"), HasSubstr("decimal comma"));
  EXPECT_THAT(number_hint("1,5e-3"), HasSubstr("decimal comma"));
  EXPECT_THAT(number_hint("\xE2\x88\x92"
                          "0.5"),
              HasSubstr("minus"));
  for (const char* plain : {"", "one", "1.2.3", "1,2,3", ","}) EXPECT_EQ(number_hint(plain), "");
}

}  // namespace
}  // namespace gonio
