// Foreign text in messages: what a terminal would obey is shown, never sent.
#include "gonio/base/shown.h"

#include <gtest/gtest.h>

#include <string>

#include "gonio/base/result.h"

namespace gonio {
namespace {

using namespace std::string_literals;

TEST(Shown, LeavesTextAsItIs) {
  EXPECT_EQ(shown("alpha_x"), "alpha_x");
  EXPECT_EQ(shown("Nölle 銀 \\ 🙂"), "Nölle 銀 \\ 🙂");
  EXPECT_EQ(shown(""), "");
}

TEST(Shown, EscapesWhatATerminalObeys) {
  EXPECT_EQ(shown("\x1b]0;title\x07"), "\\x1b]0;title\\x07");
  EXPECT_EQ(shown("a\nb\rc\td"), "a\\nb\\rc\\td");
  EXPECT_EQ(shown("A\0B"s), "A\\x00B");
  EXPECT_EQ(shown("\x7f"), "\\x7f");
  EXPECT_EQ(shown("\u009b"
                  "31m"),
            "\\u{9b}31m");
}

TEST(Shown, EscapesWhatIsNotUtf8) {
  EXPECT_EQ(shown("\xff\xfeh"), "\\xff\\xfeh");
  EXPECT_EQ(shown("\xc0\xaf"), "\\xc0\\xaf");           // an overlong '/'
  EXPECT_EQ(shown("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a UTF-16 pair
  EXPECT_EQ(shown("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(shown("\xe9\x8a"), "\\xe9\\x8a");  // cut off
}

TEST(Shown, EscapesWhatHidesOrReorders) {
  EXPECT_EQ(shown("\u202egold"), "\\u{202e}gold");
  EXPECT_EQ(shown("\ufeff31"), "\\u{feff}31");
  EXPECT_EQ(shown("a\u2028b\u200b"), "a\\u{2028}b\\u{200b}");
}

TEST(Shown, IsTheSameTwice) {
  for (const std::string& text : {"\x1b[31m"s, "\xff\u202e\n"s, "\\x1b"s, "A\0B"s}) {
    EXPECT_EQ(shown(shown(text)), shown(text));
  }
}

TEST(Shown, CutsBetweenCharacters) {
  EXPECT_EQ(shown("abcdef", 4), "abcd...");
  EXPECT_EQ(shown("abcd", 4), "abcd");
  EXPECT_EQ(shown("ab\u9280", 4), "ab...");
  EXPECT_EQ(shown("abc\n", 4), "abc...");
}

TEST(BadValue, ShowsFieldAndValue) {
  const Error error = bad_value("parameters.\x1b[2J", std::string(5000, '\n'), "one number");
  EXPECT_EQ(error.field, "parameters.\\x1b[2J");
  EXPECT_LE(error.value.size(), kQuotedLength + 3);
  EXPECT_EQ(error.message.find('\n'), std::string::npos);
  EXPECT_EQ(error.allowed, "one number");
}

}  // namespace
}  // namespace gonio
