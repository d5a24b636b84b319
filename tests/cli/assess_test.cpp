// `gonio assess` as users and pipelines see it: the table, the report, the exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/json_text.h"
#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kAssess =
    R"(gonio assess --pairs 300 --material '{"model": "cook_torrance", "parameters": {"m": 0.01, "f0": [0.9, 0.5, 0.2]}}' )";

TEST(AssessCommand, PrintsATableAndPasses) {
  const auto result = shell(kAssess);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_THAT(result.out, AllOf(HasSubstr("3 channels; stated relative errors 3e-06 (fast)"),
                                HasSubstr("exactly_opposite  300"), HasSubstr("900 NaN"),
                                HasSubstr("89.9"), HasSubstr("error_reference"),
                                HasSubstr("verdict: passed\n"), Not(HasSubstr("worst at"))));
  EXPECT_THAT(shell(kAssess + "-v").out,
              AllOf(HasSubstr("h at 1e-6 to 1 rad from n"), HasSubstr("worst at wi theta")));
}

TEST(AssessCommand, BadVerdictHasAnExitStatusOfItsOwn) {
  const auto result = shell(kAssess + "--max-error 1e-9 --max-loss 0.5");
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("FAILED"), HasSubstr("verdict: failed (error_fast, energy_loss)\n")));
  const auto quiet = shell(kAssess + "--max-error 1e-9 --quiet");
  EXPECT_EQ(quiet.exit_code, 4);
  EXPECT_THAT(quiet.out, IsEmpty());
}

TEST(AssessCommand, WritesAReport) {
  const gonio::testing::TempFolder folder;
  const std::string file = folder / "report.json";
  EXPECT_EQ(shell(kAssess + "--max-gain 0.5 --report " + file).exit_code, 0);
  const auto report = json(read_file(file));
  EXPECT_TRUE(report.fields().at("passed").bool_value());
  EXPECT_EQ(report.fields().at("checks").list_value().values_size(), 11);
  const auto& place = report.fields().at("places").list_value().values(0).struct_value();
  EXPECT_EQ(place.fields().at("name").string_value(), "hemisphere");
  EXPECT_TRUE(place.fields().contains("naive_float32"));
  // On standard output the table makes room.
  const auto piped = shell(kAssess + "--json -");
  EXPECT_FALSE(json(piped.out).fields().empty());
  EXPECT_THAT(piped.err, HasSubstr("verdict: passed"));
}

TEST(AssessCommand, BadInputIsRefused) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--max-gain -1", "limits.gain is -1; allowed: 0 to"},
      {"--max-gain x", "--max-gain"},
      {"--max-loss 2", "limits.loss is 2; allowed: 0 to 1"},
      {"--min-probability nan", "limits.probability is nan"},
      {"--pairs 0", "--pairs"},
      {"--seed 0", "--seed"},
      {"--precision fast", "--precision"}};
  for (const auto& [arguments, words] : cases) {
    const auto result = shell(kAssess + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(words)) << arguments;
    EXPECT_THAT(result.out, IsEmpty());
  }
  EXPECT_EQ(shell("gonio assess --material nothing.json").exit_code, 2);
  EXPECT_EQ(shell(kAssess + "--report /nowhere/report.json").exit_code, 1);
  EXPECT_EQ(shell(kAssess + "--server 127.0.0.1:1 --deadline 1").exit_code, 3);
}

TEST(AssessCommand, IsInTheHelp) {
  EXPECT_THAT(shell("gonio assess --help").out,
              AllOf(HasSubstr("--max-reciprocity"), HasSubstr("Exit status 4"),
                    HasSubstr("--min-probability")));
}

}  // namespace
}  // namespace gonio::test
