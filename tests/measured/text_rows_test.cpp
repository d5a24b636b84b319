// Rows of text: each is held to its own line, whatever ends the lines and however the text begins.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>

#include "data_folder.h"
#include "measured/pairs.h"

namespace gonio::testing {
namespace {

using namespace std::string_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string message(const Result<MeasuredPairs>& result) {
  return result ? "no error" : result.error().message;
}

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// Each end of a line with the next of three in its place.
std::string mixed_ends(const std::string& text) {
  const std::array<std::string, 3> ends{"\r\n", "\r", "\n"};
  std::string mixed;
  std::size_t count = 0;
  for (const char c : text) mixed += c == '\n' ? ends[count++ % ends.size()] : std::string(1, c);
  return mixed;
}

std::string utf16(const std::string& ascii) {
  std::string wide;
  for (const char c : ascii) wide += {c, '\0'};
  return wide;
}

TEST(CornellRows, AreNotReadAcrossLineEnds) {
  EXPECT_THAT(message(read_cornell(text_case("cornell_1_wavelength_2_columns.brdf"))),
              AllOf(HasSubstr(".brdf:2: found 6 numbers; expected 5: theta_i, phi_i"),
                    HasSubstr("a value for each of 1 wavelengths")));
  EXPECT_THAT(message(read_cornell(text_case("cornell_line4_lost_value.brdf"))),
              HasSubstr(".brdf:4: found 4 numbers; expected 5"));
}

TEST(CornellRows, HeadMayTakeSeveralLines) {
  const std::string rows = "0.5 0 0.25 1 0.5 0.125\n";
  for (const std::string head : {"2 400 500\n", "2\n400 500\n", "# p\n2 400\n\n# nm\n500 # end\n"})
    EXPECT_EQ(message(parse_cornell(head + rows + rows, "p")), "no error") << head;
  EXPECT_THAT(message(parse_cornell("2 400 500 600\n" + rows, "p")),
              HasSubstr("p:1: found 1 more on this line; expected its end"));
  EXPECT_THAT(message(parse_cornell("2 400 500 " + rows, "p")), HasSubstr("p:1: found 6 more"));
  // A wavelength too few: the row's first number is taken for one, and the rest is left.
  EXPECT_THAT(message(parse_cornell("3 400 500\n" + rows, "p")), HasSubstr("p:2: found 5 more"));
  EXPECT_THAT(message(parse_cornell("1 0\n" + rows, "p")), HasSubstr("a wavelength in nm"));
  EXPECT_THAT(message(parse_cornell("1 inf\n" + rows, "p")), HasSubstr("a wavelength in nm"));
}

TEST(AltaRows, AreNotReadAcrossLineEnds) {
  EXPECT_THAT(message(read_alta(text_case("alta_dim_says_1_rows_have_3.alta"))),
              AllOf(HasSubstr(".alta:4: found 6 numbers; expected 4: theta_i"),
                    HasSubstr("as many values as #DIM 3 1 says")));
}

TEST(AltaRows, HeadIsReadWhole) {
  const std::string rest = "#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI\n0.5 0.3 0.4 0.25\n";
  EXPECT_EQ(message(parse_alta("#DIM\t3  1 \n" + rest, "t")), "no error");
  EXPECT_EQ(message(parse_alta("#DIM 3 1\n#DIM 3 1\n" + rest, "t")), "no error");
  for (const char* wrong : {"3 1.5", "3 1 7", "3", "3 x", "3.5 1", "3 1e9"}) {
    EXPECT_THAT(message(parse_alta("#DIM "s + wrong + "\n" + rest, "t")),
                AllOf(HasSubstr("t:1: found #DIM "s + wrong), HasSubstr("#DIM 3 and the number")));
  }
  EXPECT_THAT(message(parse_alta("#DIM 3 1\n#DIM 3 2\n" + rest, "t")),
              HasSubstr("t:2: found #DIM 3 2; expected the same as on line 1"));
}

// The same numbers whatever ends the lines, also mixed, and behind a byte-order mark.
TEST(TextRows, EndsOfLinesAndMarksMakeNoDifference) {
  const std::string cornell = "# p\n2\n400\n500\n\n0.5 0 0.25 1 0.5 1e-3\n0.5 0 0.25 -1 0.1 0.25";
  const std::string alta =
      "#DIM 3 1\n#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI\n#VS 0\n0.5 0.3 0.4 0.25\n0.5 0 0 0.125\n";
  const auto check = [](auto parse, const std::string& text) {
    const auto plain = parse(text, "p");
    ASSERT_TRUE(plain.ok()) << message(plain);
    ASSERT_EQ(plain->size(), 2U);
    for (const std::string& other : {replaced(text, "\n", "\r"), replaced(text, "\n", "\r\n"),
                                     mixed_ends(text), "\xEF\xBB\xBF" + text}) {
      const auto same = parse(other, "p");
      ASSERT_TRUE(same.ok()) << message(same);
      EXPECT_EQ(same->wi, plain->wi);
      EXPECT_EQ(same->wo, plain->wo);
      EXPECT_EQ(same->values, plain->values);
    }
  };
  check(parse_cornell, cornell);
  check(parse_alta, alta);
}

TEST(TextRows, ErrorsCountLinesWhateverEndsThem) {
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    const std::string text =
        "# p" + end + "1 500" + end + end + "0 0 0 0 1" + end + "0 0 0 1" + end;
    EXPECT_THAT(message(parse_cornell(text, "p")), HasSubstr("p:5: found 4 numbers"));
  }
}

TEST(TextRows, NumbersAsOtherProgramsWriteThem) {
  const auto plus = read_cornell(text_case("plus_sign.brdf"));
  ASSERT_TRUE(plus.ok()) << message(plus);
  EXPECT_EQ(plus->values, (std::vector<double>{0.1, 0.1}));
  EXPECT_DOUBLE_EQ(plus->wo[2], std::cos(0.5));
  const auto fortran = parse_cornell("1 5.0D+02\n0 0 5.0D-01 0 +1.25d-01\n", "p");
  ASSERT_TRUE(fortran.ok()) << message(fortran);
  EXPECT_EQ(fortran->values[0], 0.125);
  // Not finite, which whoever uses the pair leaves out and counts.
  EXPECT_TRUE(std::isnan(parse_cornell("1 500\n0 0 0 0 nan\n", "p")->values[0]));
  EXPECT_THAT(message(parse_cornell("1 500\n0 0 0,5 0 1\n", "p")),
              HasSubstr("p:2: found '0,5' (a decimal comma: write a point)"));
}

TEST(TextRows, OtherEncodingsAreNamed) {
  EXPECT_THAT(message(parse_cornell("\xFF\xFE" + utf16("1 500\n"), "p")),
              HasSubstr("p is UTF-16 text"));
  EXPECT_THAT(message(parse_alta(utf16("#DIM 3 1\n"), "p")), HasSubstr("p is UTF-16 text"));
}

TEST(TextRows, MarkAloneIsNoError) {
  EXPECT_THAT(message(read_cornell(text_case("bom_cornell.brdf"))),
              HasSubstr("found the end of the file; expected rows of theta_i"));
}

// What a message quotes of a file is text on one line, and all of the message is there.
TEST(TextRows, ErrorsShowForeignBytes) {
  EXPECT_THAT(message(read_cornell(text_case("nul.brdf"))),
              AllOf(HasSubstr("found 'A\\x00B'; expected theta_i"), Not(HasSubstr("\0"s))));
  EXPECT_THAT(message(parse_cornell("\x1b[31m", "a\nb")), HasSubstr("a\\nb:1: found '\\x1b[31m'"));
  const std::string long_word(10'000, 'x');
  EXPECT_LT(message(parse_cornell("1 500\n" + long_word, "p")).size(), 400U);
  EXPECT_THAT(message(parse_alta("#DIM \x1b]0;t\x07\n", "p")), HasSubstr("#DIM \\x1b]0;t\\x07"));
  EXPECT_THAT(message(read_rgl(text_case("zemax_style.bsdf"))),
              HasSubstr("found 'Source  Measur' at its beginning; expected `tensor_file`"));
  EXPECT_THAT(message(parse_rgl("\x1b[2J", "p")), HasSubstr("'\\x1b[2J' at its beginning"));
}

TEST(MeasuredFiles, GreyTapeWithAnotherDimensionIsRefused) {
  const auto file = data_folder() / "retro" / "retro-gray-tape.dat";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file << ": set GONIO_DATA";
  const std::string text = content(file);
  EXPECT_EQ(message(parse_alta(text, "tape")), "no error");
  EXPECT_THAT(message(parse_alta(replaced(text, "#DIM 3 1", "#DIM 3 2"), "tape")),
              AllOf(HasSubstr("tape:7: found 4 numbers; expected 5"),
                    HasSubstr("as many values as #DIM 3 2 says")));
}

}  // namespace
}  // namespace gonio::testing
