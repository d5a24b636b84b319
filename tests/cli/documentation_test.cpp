// What the tool writes of its models for others to read, and that their page holds it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::vector<std::string> lines_with(const std::string& text, const std::string& pattern) {
  std::vector<std::string> found;
  for (const std::string& line : lines_of(text)) {
    if (std::regex_search(line, std::regex(pattern))) found.push_back(line);
  }
  return found;
}

std::string evaluated(const std::string& parameters) {
  const auto result = shell(R"(gonio evaluate --material '{"model": "ggx", "parameters": {)" +
                            parameters + "}}' --grid theta_i=0.5");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.out;
}

TEST(Presets, AreListedOnceEach) {
  const auto list = shell("gonio models --presets");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_THAT(list.err, IsEmpty());
  EXPECT_THAT(list.out, StartsWith("PARAMETER"));
  // In the order of the models that have them.
  EXPECT_THAT(lines_with(list.out, " copper "),
              ElementsAre(AllOf(HasSubstr("f0"), HasSubstr("rs"), HasSubstr("0.95"),
                                HasSubstr("0.64"), HasSubstr("0.54"), HasSubstr("2008")),
                          AllOf(StartsWith("eta (with k) "), HasSubstr("1972")),
                          AllOf(StartsWith("k (with eta) "), HasSubstr("1972"))));
  EXPECT_THAT(lines_with(list.out, " glass "),
              ElementsAre(AllOf(HasSubstr("1.79"), HasSubstr("0.04"))));
  EXPECT_THAT(shell("gonio models lambertian --presets").out, HasSubstr("No parameter"));
}

TEST(Presets, StandInThePlaceOfNumbers) {
  EXPECT_EQ(evaluated(R"("f0": "copper")"), evaluated(R"("f0": [0.95, 0.64, 0.54])"));
  EXPECT_EQ(evaluated(R"("eta": "gold", "k": "gold")"),
            evaluated(R"("eta": [0.14, 0.43, 1.38], "k": [3.697, 2.455, 1.914])"));
  EXPECT_THAT(shell("gonio models ggx").out, HasSubstr("diamond"));
}

TEST(Presets, AnUnknownOneIsAWrongArgument) {
  const auto result = shell(
      R"(gonio evaluate --material '{"model": "ggx", "parameters": {"f0": "bronze"}}' --grid theta_i=0)");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("f0"), HasSubstr("bronze"), HasSubstr("[0, 1]"),
                                HasSubstr("copper")));
}

TEST(Markdown, HasEveryModelParameterAndPreset) {
  const auto page = shell("gonio models --markdown");
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_THAT(page.err, IsEmpty());
  EXPECT_EQ(lines_with(page.out, "^\\| `ggx` ").size(), 1U);
  EXPECT_THAT(lines_with(page.out, "^\\| `f0` "),
              ElementsAre(AllOf(HasSubstr("0 to 1, a colour or a preset"), HasSubstr("`schlick`"),
                                HasSubstr("`cook_torrance`"), HasSubstr("`ggx`"))));
  EXPECT_EQ(lines_with(page.out, "^\\| `gold` ").size(), 2U);  // eta and k
  EXPECT_THAT(lines_with(page.out, "^\\| `oren_nayar` "), ElementsAre(HasSubstr("albedo up to")));
  for (const char* both : {"--json", "--presets"}) {
    EXPECT_EQ(shell("gonio models --markdown " + std::string(both)).exit_code, 2);
  }
}

// Every row has as many cells as its table's header.
TEST(Markdown, TablesAreWhole) {
  std::size_t cells = 0;
  for (const std::string& line : lines_of(shell("gonio models --markdown").out)) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
      found += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
    if (found > 0 && cells > 0) {
      EXPECT_EQ(found, cells) << line;
    }
    cells = found;
  }
}

TEST(ModelsPage, HoldsTheModelsAsTheyAre) {
  const std::string page = read_file(GONIO_MODELS_PAGE);
  const std::string begin = "<!-- models: begin (gonio models --markdown) -->\n";
  const std::string end = "<!-- models: end -->\n";
  const auto from = page.find(begin), to = page.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::string section = page.substr(from + begin.size(), to - from - begin.size());
  EXPECT_EQ(section, "\n" + shell("gonio models --markdown").out + "\n")
      << "src/models/README.md is out of date; refresh it: "
         "tests/style/refresh_readme.sh " GONIO_PROGRAM;
}

}  // namespace
}  // namespace gonio::test
