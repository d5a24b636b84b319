// What completes the arguments in a shell, and the manual pages: both as bash and man use them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

// What bash offers for a command line that ends where the cursor is.
std::vector<std::string> offered(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += " '" + word + "'";
  const auto result = shell(
      "set -u; d=$(mktemp -d) && cd $d && touch gold.json && source <(gonio completion bash) && "
      "COMP_WORDS=(" +
      line + ") COMP_CWORD=" + std::to_string(words.size() - 1) +
      " && _gonio && printf '%s\\n' \"${COMPREPLY[@]}\"; rm -r $d");
  EXPECT_THAT(result.err, IsEmpty());
  return lines_of(result.out);
}

TEST(Completion, OffersCommandsOptionsWordsAndFiles) {
  EXPECT_THAT(offered({"gonio", ""}), IsSupersetOf({"models", "evaluate", "compare", "select"}));
  EXPECT_THAT(offered({"gonio", "re"}), UnorderedElementsAre("render"));
  EXPECT_THAT(offered({"gonio", "--ver"}), UnorderedElementsAre("--version"));
  EXPECT_THAT(offered({"gonio", "render", "--sh"}), UnorderedElementsAre("--shape"));
  EXPECT_THAT(offered({"gonio", "render", "--shape", ""}),
              UnorderedElementsAre("sphere", "cylinder", "plane"));
  EXPECT_THAT(offered({"gonio", "render", "--shape", "=", "pl"}), UnorderedElementsAre("plane"));
  EXPECT_THAT(offered({"gonio", "render", "-m", "go"}), UnorderedElementsAre("gold", "gold.json"));
  EXPECT_THAT(offered({"gonio", "evaluate", "--pairs", ""}), UnorderedElementsAre("gold.json"));
  EXPECT_THAT(offered({"gonio", "fit", "--model", "ggx:s"}), UnorderedElementsAre("ggx:schlick"));
  EXPECT_THAT(offered({"gonio", "models", "gg"}), UnorderedElementsAre("ggx"));
  EXPECT_THAT(offered({"gonio", "completion", "f"}), Contains("fish"));
  EXPECT_THAT(offered({"gonio", "albedo", "-"}), AllOf(Contains("--theta"), Each(StartsWith("-"))));
}

// Every option that a help page lists is offered.
TEST(Completion, KnowsEveryOptionOfTheHelp) {
  const std::string script = shell("gonio completion bash").out;
  const auto options = lines_of(
      shell("for c in '' models evaluate sample albedo lobe render fit compare put assess select "
            "chart; do gonio $c --help; done | grep -oE '^  -[-a-zA-Z,]+' | tr -d ' ' | tr , '\\n'")
          .out);
  EXPECT_GT(options.size(), 100U);
  for (const std::string& option : options) EXPECT_THAT(script, HasSubstr(option));
}

TEST(Completion, ScriptsOfOtherShells) {
  EXPECT_THAT(shell("gonio completion fish").out,
              AllOf(HasSubstr("complete -c gonio"), HasSubstr("'sphere cylinder plane'")));
  EXPECT_THAT(shell("gonio completion zsh").out, StartsWith("#compdef gonio\n"));
  const auto none = shell("gonio completion tcsh");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("bash, fish, zsh"));
}

TEST(Man, PagesHaveWhatTheHelpHas) {
  const auto page = shell("gonio man render");
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_THAT(page.out, AllOf(StartsWith(".TH GONIO\\-RENDER 1"), HasSubstr(".SH OPTIONS"),
                              HasSubstr("\\fB\\-\\-shape\\fR \\fIS\\fR"), HasSubstr("Examples:"),
                              HasSubstr("Exit status:")));
  EXPECT_THAT(shell("gonio man").out, AllOf(HasSubstr(".SH COMMANDS"), HasSubstr("gonio\\-fit")));
  const gonio::testing::TempFolder folder;
  EXPECT_EQ(shell("gonio man -o " + (folder / "man1").string()).exit_code, 0);
  const auto pages = lines_of(shell("ls " + (folder / "man1").string()).out);
  EXPECT_THAT(pages, IsSupersetOf({"gonio.1", "gonio-evaluate.1", "gonio-select.1"}));
  const auto wrong = shell("gonio man rendr");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("mean \"render\"?"));
}

// A line that begins with a dot would be a request to roff.
TEST(Man, NoLineOfProseIsTakenForARequest) {
  for (const std::string& line : lines_of(shell("gonio man fit; gonio man evaluate").out)) {
    if (line[0] != '.') continue;
    EXPECT_THAT(line, ::testing::ContainsRegex("^\\.(TH|SH|TP|nf|fi)")) << line;
  }
  EXPECT_THAT(shell("gonio man fit").out, Not(HasSubstr("\n.binary")));
}

TEST(Help, EachCommandSaysItsExitStatus) {
  for (const char* command : {"models", "evaluate", "fit", "compare", "put", "chart"}) {
    const std::string help = shell(std::string("gonio ") + command + " --help").out;
    EXPECT_THAT(help, AllOf(HasSubstr("Exit status:"), HasSubstr("  3  no answer"))) << command;
    EXPECT_THAT(help, Not(HasSubstr("  4  "))) << command;
  }
  for (const char* command : {"assess", "select"})
    EXPECT_THAT(shell(std::string("gonio ") + command + " --help").out,
                HasSubstr("  4  done, but"));
}

}  // namespace
}  // namespace gonio::test
