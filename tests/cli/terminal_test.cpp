// Foreign text on a terminal: shown, never obeyed, and never a line of its own.
#include "client/cli/output/terminal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"
#include "client/cli/output/json.h"
#include "client/cli/output/text.h"
#include "data_folder.h"

namespace gonio::test {
namespace {

using namespace std::string_literals;
using ::gonio::testing::text_case;

using ::testing::HasSubstr;

const std::string kWhite = R"('{"model": "lambertian", "parameters": {"rd": 0.5}}')";

// Nothing but lines of text, and one line to say what is wrong.
void expect_plain(const Finished& result) {
  for (const std::string& text : {result.out, result.err}) {
    for (const char c : text)
      EXPECT_TRUE(c == '\n' || (c >= ' ' && c != '\x7f')) << int{c} << "\n" << text;
  }
}

TEST(Terminal, ShowsLineByLine) {
  EXPECT_EQ(cli::shown_lines("a\nb\x1b[31m\n\n"), "a\nb\\x1b[31m\n\n");
  EXPECT_EQ(cli::shown_lines("no end\r"), "no end\\r");
  EXPECT_EQ(cli::shown_lines(""), "");
  EXPECT_EQ(cli::padded("a\nb", 8), "a\\nb    ");
  EXPECT_EQ(cli::wrapped("reason\x1b[2J\nforged", 4), "reason\\x1b[2J\\nforged");
}

TEST(Terminal, JsonKeepsWhatItCan) {
  EXPECT_EQ(cli::json_string("a\n\x1b"), "\"a\\n\\u001b\"");
  EXPECT_EQ(cli::json_string("\u202e\u9280"), "\"\\u202e\u9280\"");
  EXPECT_EQ(cli::json_string("\xff.csv"), "\"\\\\xff.csv\"");  // was lost
}

TEST(Terminal, OfFilesBytes) {
  const auto esc =
      shell("gonio evaluate -m " + kWhite + " --pairs " + text_case("esc.csv").string());
  EXPECT_EQ(esc.exit_code, 2);
  EXPECT_THAT(esc.err, HasSubstr("esc.csv:1: the header has none of the columns, found "
                                 "'\\x1b]0;title\\x07\\x1b[31mtheta_i,phi'"));
  expect_plain(esc);
  const auto nul = shell("gonio fit --model lambertian --data " + text_case("nul.brdf").string());
  EXPECT_EQ(nul.exit_code, 2);
  EXPECT_THAT(nul.err, HasSubstr("found 'A\\x00B'; expected theta_i"));  // and what follows
  expect_plain(nul);
  const auto field = shell("gonio fit --model lambertian --data -",
                           "theta_i,phi_i,theta_o,phi_o,f_0\n1,2,3,4,\x1b[2J\0\x9b\n"s);
  EXPECT_THAT(field.err, HasSubstr("(f_0): '\\x1b[2J\\x00\\x9b' is not a number"));
  expect_plain(field);
}

TEST(Terminal, OfJson) {
  const gonio::testing::TempFolder folder;
  for (const std::string& content :
       {"{\"model\": \"ggx\", \"\x1b[31mgloss\": 1}"s, "{\"model\": \"\\u001b[31m\\n:status\"}"s,
        "{\"model\": \"ggx\", \"parameters\": {\"\\u001b[2J\\ngonio: forged\": 1}}"s,
        "{\"model\": \"ggx\"\n\x1b[31m\n"s, "{\"model\": \"\xff\"}"s, "{\0}"s}) {
    write_file(folder / "m.json", content);
    for (const std::string& command : {"gonio evaluate --grid theta_i=0.5 -m "s,
                                       "gonio select --reference m.binary --scene "s}) {
      const auto result = shell(command + (folder / "m.json").string());
      EXPECT_EQ(result.exit_code, 2) << content;
      EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
      expect_plain(result);
    }
  }
}

TEST(Terminal, OfNamesAndArguments) {
  const std::string forged = "$'no\\ngonio: error: forged\\e[31m'";
  for (const std::string& command :
       {"gonio evaluate --grid theta_i=0.5 -m " + forged, "gonio models " + forged,
        "gonio evaluate -m " + kWhite + " --pairs " + forged,
        "gonio evaluate -m " + kWhite + " --grid theta_i=0 -o /nowhere/" + forged,
        "gonio fit --model lambertian --data " + forged + ".brdf",
        "gonio fit --model lambertian --data " + forged + ".binary",
        "gonio fit --deg --model " + forged + " --data " + text_case("cr_only_data.csv").string(),
        "gonio render -m " + kWhite + " -o x.png --light " + forged + ".exr",
        "gonio put --server unix:/nowhere.sock x " + forged,
        "gonio compare --reference " + forged + ".bsdf -m " + kWhite,
        "gonio select --scene " + forged}) {
    const auto result = shell(command);
    EXPECT_NE(result.exit_code, 0) << command;
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
    EXPECT_THAT(result.err, HasSubstr("no\\ngonio"));
    expect_plain(result);
  }
  const auto option = shell("gonio evaluate $'--b\\e[31m\\nforged'");
  EXPECT_EQ(option.exit_code, 2);
  expect_plain(option);
}

TEST(Terminal, OfTables) {
  const gonio::testing::TempFolder folder;
  const std::string name = (folder / "a\x1b[31m\nb.json").string();
  write_file(name, R"({"model": "lambertian"})");
  const auto result = shell("gonio compare --deg --reference " +
                            text_case("cr_only_data.csv").string() + " -m '" + name + "'");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\na\\x1b[31m\\nb.json "));
  expect_plain(result);
}

}  // namespace
}  // namespace gonio::test
