// `gonio sample`, `gonio albedo` and `gonio evaluate --pdf`: what they write, and what they refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::string kLambertian =
    R"(--material '{"model": "lambertian", "parameters": {"rd": [0.5, 0.25]}}' )";
const std::string kGgx =
    R"(--material '{"model": "ggx", "parameters": {"f0": 1, "alpha_x": 0.9, "alpha_y": 0.9}}' )";
const std::string kSample = "gonio sample " + kLambertian;
const std::string kAlbedo = "gonio albedo " + kLambertian;

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t comma = std::min(line.find(',', at), line.size());
    numbers.push_back(std::stod(line.substr(at, comma - at)));
    at = comma + 1;
  }
  return numbers;
}

TEST(SampleCommand, CsvHasDirectionDensityWeightsAndFlags) {
  const auto result = shell(kSample + "--wi 0.6,0,0.8 --count 20 --seed 5");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 21U);
  EXPECT_EQ(lines[0], "wo_x,wo_y,wo_z,pdf,w_0,w_1,flags");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto row = numbers_of(lines[i]);
    ASSERT_EQ(row.size(), 7U);
    EXPECT_NEAR(row[0] * row[0] + row[1] * row[1] + row[2] * row[2], 1, 1e-6);
    EXPECT_NEAR(row[3], row[2] / 3.14159265, 1e-6);
    EXPECT_NEAR(row[4], 0.5, 1e-5);
    EXPECT_NEAR(row[5], 0.25, 1e-5);
    EXPECT_EQ(row[6], 0);
  }
  EXPECT_EQ(shell(kSample + "--wi 0.6,0,0.8 --count 20 --seed 5 --threads 1").out, result.out);
  EXPECT_NE(shell(kSample + "--wi 0.6,0,0.8 --count 20 --seed 6").out, result.out);
  EXPECT_NE(shell(kSample + "--wi 0.6,0,0.8 --count 20 --seed 5 --sequence sobol").out, result.out);
}

TEST(SampleCommand, FilesOfDirections) {
  const std::string csv = "theta_i,phi_i\n0,0\n60,90\n";
  const auto result = shell(kSample + "--wi-file - --deg --count 2 --with-input", csv);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_THAT(lines[0], StartsWith("wi_x,wi_y,wi_z,wo_x,"));
  EXPECT_THAT(lines[2], StartsWith("0,0,1,"));
  EXPECT_NEAR(numbers_of(lines[3])[1], 0.8660254, 1e-6);
  EXPECT_NEAR(numbers_of(lines[4])[2], 0.5, 1e-6);
  const std::string xyz = "wi_z,wi_x,wi_y\n1,0,0\n-1,0,0\n";
  const auto flagged = shell(kSample + "--wi-file - --count 3", xyz);
  EXPECT_EQ(flagged.exit_code, 0);
  EXPECT_THAT(flagged.err, HasSubstr("3 of 6 samples are flagged"));
  EXPECT_THAT(flagged.err, HasSubstr("3 wi below the horizon"));
}

TEST(SampleCommand, NpyAndJson) {
  const gonio::testing::TempFolder folder;
  const std::string npy = folder / "samples.npy";
  const auto run = shell(kSample + "--wi 0,0,1 --count 10 -o " + npy);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string content = read_file(npy);
  EXPECT_THAT(content, HasSubstr("'shape': (10, 6)"));
  EXPECT_EQ(content.size(), 128 + 10 * 6 * sizeof(float));
  const auto json = shell(kSample + "--wi 0,0,1 --count 1 --format json");
  EXPECT_THAT(json.out,
              StartsWith("{\"channels\": 2,\n\"columns\": [\"wo_x\", \"wo_y\", \"wo_z\", \"pdf\", "
                         "\"w_0\", \"w_1\"],\n\"samples\": [\n["));
  EXPECT_THAT(json.out, HasSubstr("\"report\": {\"samples\": 1, "));
  EXPECT_THAT(json.out, HasSubstr("\"lost\": 0"));
}

TEST(SampleCommand, LostSamplesAreSaid) {
  const auto result = shell("gonio sample " + kGgx + "--wi 0.99,0,0.14106736 --count 1000");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, AllOf(HasSubstr("of 1000 samples"), HasSubstr("wo below the horizon")));
}

TEST(SampleCommand, BadInputIsRefusedAndNothingIsWritten) {
  const gonio::testing::TempFolder folder;
  const auto listing = [&] { return shell("ls -A " + (folder / "").string()).out; };
  const std::string file = folder / "out.csv";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--wi 0,0,1 --count 0", "--count is 0; allowed: 1 to 1000000000"},
      {"--wi 0,0,1 --count -1", "--count is -1"},
      {"--wi 0,0,1 --count 1000000000000", "--count is 1000000000000"},
      {"--wi 0,0,-1 --count 1", "--wi is 0,0,-1 (wi below the horizon)"},
      {"--wi 0,0,2 --count 1", "(not unit)"},
      {"--wi nan,0,1 --count 1", "(not finite)"},
      {"--wi 0,1 --count 1", "--wi is '0,1'"},
      {"--wi 0,0,1,0 --count 1", "--wi is '0,0,1,0'"},
      {"--count 1", "--wi X,Y,Z or --wi-file FILE"},
      {"--wi 0,0,1 --count 1 --sequence halton", "--sequence"},
      {"--wi-file nothing.csv --count 1", "nothing.csv"},
  };
  for (const auto& [arguments, words] : cases) {
    const auto result = shell(kSample + arguments + " -o " + file);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(words)) << arguments;
    EXPECT_THAT(listing(), IsEmpty()) << arguments;
  }
  const auto half =
      shell(kSample + "--wi-file - --count 1 -o " + file, "wi_x,wi_y,wi_z\n0,0,1\n0,x,1\n");
  EXPECT_EQ(half.exit_code, 2);
  EXPECT_THAT(half.err, HasSubstr(":3, column 2 (wi_y): 'x' is not a number"));
  EXPECT_THAT(listing(), IsEmpty());
  const auto unwritable = shell(kSample + "--wi 0,0,1 --count 1 -o /nowhere/out.csv");
  EXPECT_EQ(unwritable.exit_code, 1);
  EXPECT_THAT(unwritable.err, HasSubstr("/nowhere/out.csv"));
}

TEST(AlbedoCommand, PrintsATable) {
  const auto result = shell(kAlbedo + "--theta 0,30,60");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_THAT(lines[0], AllOf(HasSubstr("theta"), HasSubstr("albedo_1"), HasSubstr("error_1"),
                              HasSubstr("lost")));
  EXPECT_THAT(lines[2], AllOf(HasSubstr("30.000"), HasSubstr("0.500000"), HasSubstr("0.250000")));
}

TEST(AlbedoCommand, JsonAndBadDirections) {
  const std::string csv = "wi_x,wi_y,wi_z\n0,0,1\n0,0,-1\n";
  const auto json = shell(kAlbedo + "--wi-file - --count 100 --format json", csv);
  EXPECT_EQ(json.exit_code, 0) << json.err;
  EXPECT_THAT(json.out, StartsWith("{\"channels\": 2,\n\"albedos\": [\n{\"wi\": [0, 0, 1], "));
  EXPECT_THAT(json.out, HasSubstr("\"lost\": 0, \"holes\": 0, \"flags\": 8}"));
  EXPECT_THAT(shell(kAlbedo + "--wi-file - --count 100", csv).out,
              HasSubstr("wi below the horizon"));
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--theta 90", "angles from 0 to below 90"},
      {"--theta 0,x", "--theta is 'x'"},
      {"--theta 0 --count 1", "--count is 1; allowed: 2"},
      {"--theta 0 --count 1000000000000", "--count is 1000000000000"},
      {"--theta 0 --wi 0,0,1", "given twice"},
      {"", "missing"}};
  for (const auto& [arguments, words] : cases) {
    const auto result = shell(kAlbedo + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(words)) << arguments;
  }
}

TEST(EvaluatePdf, IsAColumnAfterTheChannels) {
  const std::string pairs = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n0,0,1,0.6,0,0.8\n0,0,-1,0.6,0,0.8\n";
  const auto result = shell("gonio evaluate " + kLambertian + "--pdf --pairs -", pairs);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], "f_0,f_1,pdf,flags");
  EXPECT_NEAR(numbers_of(lines[1])[2], 0.8 / 3.14159265, 1e-7);
  EXPECT_EQ(lines[2], "0,0,0,8");
  EXPECT_THAT(shell("gonio evaluate " + kLambertian + "--pdf --format json --pairs -", pairs).out,
              HasSubstr("\"columns\": [\"f_0\", \"f_1\", \"pdf\"]"));
}

}  // namespace
}  // namespace gonio::test
