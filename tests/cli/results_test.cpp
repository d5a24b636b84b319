// Where the results of fit, compare, assess and select go, and what happens when they cannot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Results : public ::testing::Test {
 protected:
  void SetUp() override {
    write_file(folder_ / "gloss.json",
               R"({"model": "ggx", "parameters": {"f0": [0.9, 0.5, 0.2], "alpha_x": 0.3}})");
    write_file(folder_ / "grey.json", R"({"model": "lambertian", "parameters": {"rd": 0.2}})");
    write_file(folder_ / "scene.json",
               R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.6})");
    write_file(folder_ / "costs.json", R"({"lambertian": 1})");
    write_file(folder_ / "two.json",
               R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.6, "materials": {
                     "gloss": {"reference": "gloss.json"}, "grey": {"reference": "grey.json"}}})");
    ASSERT_EQ(here("gonio evaluate --material gloss.json --deg --with-input --grid "
                   "theta_i=5:75:8,theta_o=0:80:17,phi_o=0:350:36 -o data.csv")
                  .exit_code,
              0);
  }

  [[nodiscard]] Finished here(const std::string& line) const {
    return shell("cd '" + (folder_ / "").string() + "'; " + line);
  }

  gonio::testing::TempFolder folder_;
};

const std::string kFit = "gonio fit --data data.csv --deg --model ggx:schlick ";
const std::string kSelect = "gonio select --scene scene.json --no-front ";

TEST_F(Results, AnInterruptLeavesNoneOfSeveralFilesBehind) {
  const auto result =
      here("mkdir out; " GONIO_PROGRAM
           " fit --data data.csv --deg --model all --lobes 2 --anisotropic --starts 100 --polish "
           "-o out/m.json --report out/r.json --report out/r.md & pid=$!; "
           "while kill -0 $pid && [ $(ls -A out | wc -l) != 3 ]; do sleep 0.02; done; "
           "kill -TERM $pid; wait $pid; echo $?; ls -A out");
  EXPECT_EQ(result.out, "143\n") << result.err;
}

TEST_F(Results, AnInputIsNotOverwritten) {
  const std::string data = read_file(folder_ / "data.csv");
  const std::string gloss = read_file(folder_ / "gloss.json");
  for (const std::string& line :
       {kFit + "-o data.csv", kFit + "--report ./data.csv",
        kSelect + "--reference gloss.json -o gloss.json",
        kSelect + "--reference gloss.json --report scene.json",
        kSelect + "--reference gloss.json --costs costs.json -o costs.json",
        std::string("gonio select --scene two.json -o ."),
        std::string("gonio assess --material gloss.json --report gloss.json")}) {
    const auto result = here(line);
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_THAT(result.err, HasSubstr("allowed: a file that is not read")) << line;
    EXPECT_THAT(result.out, IsEmpty()) << line;
  }
  EXPECT_EQ(read_file(folder_ / "data.csv"), data);
  EXPECT_EQ(read_file(folder_ / "gloss.json"), gloss);
}

TEST_F(Results, OnePlaceTakesOneResult) {
  for (const std::string& line :
       {kFit + "-o a --report ./a", kFit + "-o - --report -", kFit + "--report a --report a",
        kSelect + "--reference gloss.json -o a --report a",
        std::string("gonio select --scene two.json -o a --report a/grey.json"),
        std::string("gonio compare --reference data.csv --deg --material gloss.json --slices a.png "
                    "--render a.png")}) {
    const auto result = here(line);
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_THAT(result.err, HasSubstr("allowed: another place")) << line;
    EXPECT_THAT(result.out, IsEmpty()) << line;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a"));
  EXPECT_EQ(here(kFit + "-q -o /dev/null --report /dev/null").exit_code, 0);
}

TEST_F(Results, AFullDiskIsAFailureOfTables) {
  for (const std::string& line :
       {kFit, kSelect + "--reference gloss.json",
        std::string("gonio assess --pairs 10 --material gloss.json"),
        std::string("gonio compare --reference data.csv --deg --material gloss.json")}) {
    const auto result = here(line + " > /dev/full");
    EXPECT_EQ(result.exit_code, 1) << line;
    EXPECT_THAT(result.err, HasSubstr("standard output cannot be written")) << line;
    EXPECT_EQ(here("set -o pipefail; " + line + " | head -1").exit_code, 0) << line;
  }
}

TEST_F(Results, AQuietFitThatFailsSaysWhy) {
  write_file(folder_ / "none.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0.5,0,0.4,0,nan\n");
  const auto result = here("gonio fit -q --data none.csv --model ggx,lambertian -o m.json");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("every fit failed; ggx: no pair is left to fit"),
                                HasSubstr("; lambertian: no pair")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "m.json"));
}

// With a deadline that no selection meets: these must show before the work.
TEST_F(Results, WhatASelectionCannotWriteShowsBeforeTheWork) {
  write_file(folder_ / "many.json",
             R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.6, "materials": {
                   "a": {"reference": "gloss.json"}, "b": {"reference": "nowhere.binary"}}})");
  const std::string hurried = "gonio select --deadline 0.001 --scene ";
  const auto missing = here(hurried + "many.json");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("b: no such file: nowhere.binary"));
  for (const std::string& line : {std::string("two.json -o data.csv"),
                                  std::string("scene.json --reference gloss.json -o no/m.json"),
                                  std::string("scene.json --reference gloss.json --report no/m")}) {
    const auto result = here(hurried + line);
    EXPECT_EQ(result.exit_code, 1) << line;
    EXPECT_THAT(result.err, HasSubstr("cannot be written")) << line;
  }
  EXPECT_EQ(here(hurried + "two.json -o new --report new/report; ls -A new").out, "");
  // Names of a server's materials may have dots in them.
  EXPECT_THAT(here(hurried + "scene.json --server 127.0.0.1:1 --reference gold.v2").err,
              ::testing::Not(HasSubstr("no such file")));
}

}  // namespace
}  // namespace gonio::test
