// Text as other programs write it: ends of lines, separators, quotes, comments, encodings; read the
// same by every command, or refused by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "cli/support/csv_text.h"
#include "cli/support/run_process.h"
#include "data_folder.h"

namespace gonio::test {
namespace {

using namespace std::string_literals;
using ::gonio::testing::text_case;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// The text with each of `from` replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

std::string mixed_ends(const std::string& text) {
  const std::array<std::string, 3> ends{"\r\n", "\r", "\n"};
  std::string mixed;
  std::size_t count = 0;
  for (const char c : text) mixed += c == '\n' ? ends[count++ % ends.size()] : std::string(1, c);
  return mixed;
}

TEST(LineEnds, OfEveryKindGiveTheSameRows) {
  for (const std::size_t count : {1, 2, 3, 5, 4001}) {
    const std::string text = kHeader + rows(count);
    const std::string expected = shell(kEvaluate + "-", text).out;
    EXPECT_EQ(lines_of(expected).size(), count + 1);
    for (const std::string& other :
         {replaced(text, "\n", "\r"), replaced(text, "\n", "\r\n"), mixed_ends(text)})
      EXPECT_EQ(shell(kEvaluate + "-", other).out, expected) << count;
    EXPECT_THAT(pairs_of(replaced(text, "\n", "\r")), HasSubstr(std::to_string(count) + " pairs"));
  }
}

TEST(LineEnds, OfReturnsAloneLoseNothingInAnyCommand) {
  const std::string pairs = text_case("cr_only_pairs.csv"), data = text_case("cr_only_data.csv");
  EXPECT_EQ(lines_of(shell(kEvaluate + pairs).out).size(), 3U);
  EXPECT_THAT(shell(kFit + data).out, HasSubstr("2 pairs"));
  const std::string white = R"(-m '{"model": "lambertian", "parameters": {"rd": 0.5}}' )";
  EXPECT_THAT(shell("gonio compare --deg " + white + "--reference " + data).out,
              HasSubstr("2 pairs, 0 left out"));
  const std::string wi = "theta_i,phi_i\r30,0\r40,0\r";
  EXPECT_EQ(lines_of(shell("gonio sample --deg --count 1 " + white + "--wi-file -", wi).out).size(),
            3U);
  EXPECT_EQ(shell("gonio albedo --deg " + white + "--wi-file -", wi).out,
            shell("gonio albedo --deg " + white + "--wi-file -", replaced(wi, "\r", "\n")).out);
}

// Files are read in blocks of 256 KiB; a pipe gives what it has.
TEST(LineEnds, MayLieAcrossTwoReads) {
  const std::string row = "30,0,30,180,1,0,", header = "theta_i,phi_i,theta_o,phi_o,f_0,flags,note";
  for (std::size_t returns_at = (1 << 18) - 3; returns_at <= (1 << 18) + 1; ++returns_at) {
    const std::size_t note = returns_at - header.size() - 2 - row.size();
    const std::string text =
        header + "\r\n" + row + std::string(note, 'x') + "\r\n" + row + "y\r\n" + row;
    ASSERT_EQ(text[returns_at], '\r');
    EXPECT_EQ(lines_of(shell(kEvaluate + "-", text).out).size(), 4U) << returns_at;
  }
  const auto slow =
      shell(R"({ printf 'theta_i,phi_i,theta_o,phi_o\r'; sleep 0.1; printf '\n1,2,3,4\r';
                               sleep 0.1; printf '\n5,6,x,8'; } | )" +
            kEvaluate + "-");
  EXPECT_THAT(slow.err, HasSubstr("standard input:3, column 3 (theta_o): 'x' is not a number"));
}

TEST(Flags, AreNumbers) {
  EXPECT_THAT(shell(kFit + text_case("flags_zero_as_float.csv").string()).out,
              HasSubstr("3 pairs\n"));
  for (const char* none :
       {"0", "0.0", "0e0", "-0", "+0", "\"0\"", "", "\"\"", "0.000000000000000000e+00"})
    EXPECT_EQ(pairs_of(kHeader + "10,0,10,180,0.1," + none + "\n20,0,20,180,0.1,0\n"), "2 pairs");
  for (const char* set : {"1", "8.0", "1e1", "\"16\"", "255"}) {
    EXPECT_EQ(pairs_of(kHeader + "10,0,10,180,0.1," + set + "\n20,0,20,180,0.1,0\n"),
              "1 pairs; left out: 1 not finite");
  }
  for (const char* wrong : {"0.5", "-1", "nan", "inf"}) {
    EXPECT_THAT(error_of(kHeader + "10,0,10,180,0.1," + wrong + "\n"),
                AllOf(HasSubstr("standard input:2, column 6 (flags) is "),
                      HasSubstr("allowed: a whole number")));
  }
  EXPECT_THAT(error_of(kHeader + "10,0,10,180,0.1,none\n"), HasSubstr("(flags): 'none' is not"));
  // Only flags may be empty: nothing is wrong is no value.
  EXPECT_THAT(error_of(kHeader + "10,0,10,180,,0\n"), HasSubstr("(f_0): '' is not a number"));
}

// numpy.savetxt writes every column as "%.18e", and its header as a comment.
TEST(NumPyText, OfGoniosOwnOutputIsReadBack) {
  const std::string own =
      shell(
          R"(gonio evaluate -m '{"model": "ggx"}' --deg --with-input --grid theta_i=5:85:9,theta_o=0:90:10,phi_o=180)")
          .out;
  std::string text;
  for (const std::string& line : lines_of(own.substr(own.find('\n') + 1))) {
    std::string row;
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t end = std::min(line.find(',', at), line.size());
      std::array<char, 40> number{};
      std::snprintf(number.data(), number.size(), "%.18e",
                    std::strtod(line.substr(at, end - at).c_str(), nullptr));
      row += (row.empty() ? "" : ",") + std::string(number.data());
      at = end + 1;
    }
    text += row + "\n";
  }
  const std::string header = first_line(own) + "\n", expected = shell(kFit + "-", own).out;
  const auto shape_of = [](const std::string& table) {
    return replaced(lines_of(table)[5], " ", "");  // the parameters and their errors
  };
  ASSERT_GT(lines_of(expected).size(), 5U) << expected;
  for (const std::string& csv : {header + text, "# " + header + text,
                                 replaced("# " + header + text, ",", " "), "#" + header + text}) {
    const auto result = shell(kFit + "-", csv);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(first_line(result.out), first_line(expected));
    EXPECT_EQ(shape_of(result.out), shape_of(expected));
  }
}

TEST(Separators, AreToldByTheHeader) {
  const std::string text = kHeader + rows(5), expected = pairs_of(text);
  EXPECT_EQ(expected, "5 pairs");
  for (const std::string separator : {";", "\t", " ; ", " ", "   ", " \t", ", "})
    EXPECT_EQ(pairs_of(replaced(text, ",", separator)), expected) << "'" << separator << "'";
  EXPECT_EQ(pairs_of("sep=;\r\n" + replaced(text, ",", ";")), expected);
  // An empty field between tabs is one.
  EXPECT_EQ(pairs_of("note\t" + replaced(kHeader, ",", "\t") + "\t1\t2\t3\t4\t0.5\t\n"), "1 pairs");
}

TEST(Separators, AreHeldToInEveryRow) {
  EXPECT_THAT(error_of(kHeader + "1;2;3;4;5;0\n"),
              HasSubstr(":2, column 1 (theta_i): '1;2;3;4;5;0'"));
  EXPECT_THAT(
      error_of(replaced(kHeader, ",", ";") + "1,5;2;3;4;5;0\n"),
      HasSubstr("column 1 (theta_i): '1,5' is not a number (a decimal comma: write a point)"));
  EXPECT_THAT(error_of(replaced(kHeader, ",", "\t") + "1\t2\t3\t4\t0,25\t0\n"),
              HasSubstr("column 5 (f_0): '0,25' is not a number (a decimal comma: write a point)"));
  EXPECT_THAT(error_of(kHeader + "1,2,3,4,0,25,0\n"), HasSubstr(":2: more than the 6 columns"));
}

// One empty field at the end of a line counts for nothing, more do.
TEST(Separators, MayEndALine) {
  EXPECT_EQ(pairs_of(kHeader + "1,2,3,4,0.5,0,\n"), "1 pairs");
  EXPECT_EQ(pairs_of(replaced(kHeader, "flags", "flags,") + "1,2,3,4,0.5,0\n1,2,3,4,0.5,0,\n"),
            "2 pairs");
  EXPECT_THAT(error_of(kHeader + "1,2,3,4,0.5,0,,\n"), HasSubstr(":2: more than the 6"));
  EXPECT_THAT(error_of(kHeader + "1,2,3,4,0.5,0,7\n"), HasSubstr(":2: more than the 6"));
  EXPECT_THAT(error_of(kHeader + "1,2,3,4,0.5\n"),
              HasSubstr(":2: fewer than the 6 columns of the header (5)"));
  EXPECT_THAT(error_of(kHeader + ",,,,,\n"), HasSubstr("column 1 (theta_i): ''"));
}

TEST(Quotes, MayStandAroundFields) {
  EXPECT_EQ(pairs_of("\"\",\"theta_i\",\"phi_i\",\"theta_o\",\"phi_o\",\"f_0\"\n"
                     "\"1\",10,\"0\", \" 10 \" ,180,0.5\n\"a, \"\"b\"\"\",10,0,10,180,0.5\n"),
            "2 pairs");
  EXPECT_EQ(pairs_of("theta_i;phi_i;theta_o;phi_o;f_0;note\n1;2;3;4;0.5;\"a;b\"\n"), "1 pairs");
  // Quotes within a field that has none around it are text.
  EXPECT_EQ(pairs_of("theta_i,phi_i,theta_o,phi_o,f_0,note\n1,2,3,4,0.5,5\" pipe\n"), "1 pairs");
  const std::string note = "note,theta_i,phi_i,theta_o,phi_o,f_0\n";
  EXPECT_THAT(error_of(note + "\"a,1,2,3,4,0.5\n"), HasSubstr(":2: quotes that do not pair"));
  EXPECT_THAT(error_of(note + "\"a\nb\",1,2,3,4,0.5\n"), HasSubstr(":2: quotes that do not pair"));
  EXPECT_THAT(error_of(note + "\"a\"b,1,2,3,4,0.5\n"), HasSubstr("or text behind them"));
  EXPECT_THAT(error_of(kHeader + "\"1,2,3,4,5,0\n"), HasSubstr("its quotes do not pair"));
}

TEST(Comments, BeginWithTheirMark) {
  const std::string row = "10,0,10,180,0.5,0\n";
  EXPECT_EQ(pairs_of("# made by hand\n\n#\n" + kHeader + "# first\n" + row + "  # end\n" + row),
            "2 pairs");
  EXPECT_EQ(pairs_of(kHeader + "#" + row + row), "1 pairs");  // a row that somebody took out
  EXPECT_EQ(pairs_of("# an older header:\n# " + kHeader + row), "1 pairs");
  EXPECT_THAT(error_of("# made by hand\n" + row), HasSubstr(":2: there is no header"));
  EXPECT_THAT(error_of("# made by hand\n\n"), HasSubstr("standard input is empty"));
  EXPECT_THAT(error_of(kHeader + "10,0,10,180,0.5,0 # good\n"),
              HasSubstr("'0 # good' is not a number"));
  // Of a column that nobody reads the mark may be a part.
  EXPECT_THAT(error_of("id," + kHeader + "#7," + row),
              AllOf(HasSubstr(":2: a line that begins with '#' and has as many fields as a row")));
  EXPECT_EQ(pairs_of("id," + kHeader + "\"#7\"," + row), "1 pairs");
}

TEST(Headers, AreMatchedInAnyCaseAndEachNameOnce) {
  EXPECT_EQ(pairs_of("Theta_I,PHI_I,theta_o,Phi_o,F_0,Flags\n10,0,10,180,0.5,0\n"), "1 pairs");
  const std::string row = "1,2,3,4,0.5,0,0\n";
  for (const char* twice : {"flags", "f_0", "theta_i", "FLAGS"}) {
    EXPECT_THAT(error_of(replaced(kHeader, "\n", ","s + twice + "\n") + row),
                AllOf(HasSubstr("standard input:1: the header has "), HasSubstr(" twice")));
  }
  EXPECT_THAT(error_of("weight,weight," + kHeader + "1,1," + row), HasSubstr("has weight twice"));
  EXPECT_THAT(error_of("theta_i,phi_i,phi_o,f_0\n1,2,3,4\n"),
              HasSubstr("the header lacks theta_o"));
  EXPECT_THAT(error_of("a,b,c\n1,2,3\n"), HasSubstr("the header has none of the columns"));
  EXPECT_THAT(error_of("10,0,10,180,0.5,0\n"), HasSubstr("there is no header"));
}

}  // namespace
}  // namespace gonio::test
