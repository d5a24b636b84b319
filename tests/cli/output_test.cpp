// What `gonio evaluate` writes: formats, digits, files that are whole or not there, pipes that
// close.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstring>

#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::StartsWith;

const std::string kEvaluate =
    R"(gonio evaluate --material '{"model": "lambertian", "parameters": {"rd": [0.5, 0.25]}}' )";
const std::string kTwo = "--grid theta_i=0/2 ";
const std::string kBad =
    R"(gonio evaluate --material '{"model": "lambertian", "parameters": {"rd": 7}}' )";

class Output : public ::testing::Test {
 protected:
  // What is in the folder, hidden files too.
  [[nodiscard]] std::string listing() const {
    return shell("ls -A " + (folder_ / "").string()).out;
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }

  gonio::testing::TempFolder folder_;
};

TEST_F(Output, CsvHasNineOrSeventeenDigits) {
  EXPECT_EQ(shell(kEvaluate + kTwo).out, "f_0,f_1,flags\n0.159154937,0.0795774683,0\n0,0,8\n");
  EXPECT_EQ(shell(kEvaluate + kTwo + "--precision reference").out,
            "f_0,f_1,flags\n0.15915494309189535,0.079577471545947673,0\n0,0,8\n");
}

TEST_F(Output, JsonIsOneObject) {
  const auto result = shell(kEvaluate + kTwo + "--format json");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(
      result.out,
      StartsWith("{\"channels\": 2,\n\"values\": [\n[0.159154937, 0.0795774683],\n[0, 0]\n],\n"
                 "\"flags\": [0, 8],\n\"report\": {\"pairs\": 2, \"kernel_seconds\": "));
  EXPECT_THAT(result.out, AllOf(HasSubstr("\"precision\": \"fast\""), HasSubstr("\"flagged\": 1"),
                                HasSubstr("\"note\": \"")));
}

TEST_F(Output, NpyByExtensionAndThroughAPipe) {
  const auto result = shell(kEvaluate + kTwo + "-o " + path("v.npy"));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, IsEmpty());
  const std::string file = read_file(path("v.npy"));
  ASSERT_EQ(file.size(), 128 + 4 * sizeof(float));
  EXPECT_THAT(file.substr(0, 128),
              HasSubstr("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2), }"));
  float values[4];
  std::memcpy(values, &file[128], sizeof(values));
  EXPECT_FLOAT_EQ(values[0], 0.159154937F);
  EXPECT_EQ(values[2], 0.0F);
  EXPECT_EQ(shell(kEvaluate + kTwo + "--format npy | cat").out, file);
  EXPECT_THAT(shell(kEvaluate + kTwo + "--format npy --precision reference | cat").out,
              HasSubstr("'<f8'"));
}

TEST_F(Output, NpyOfUnknownLengthIsTheSameAsOfKnown) {
  const std::string csv = "theta_i,phi_i,theta_o,phi_o\n0,0,0,0\n2,0,0,0\n";
  const std::string known = shell(kEvaluate + kTwo + "--format npy | cat").out;
  EXPECT_EQ(shell(kEvaluate + "--pairs - --format npy | cat", csv).out, known);
  EXPECT_EQ(shell(kEvaluate + "--pairs - -o " + path("v.npy"), csv).exit_code, 0);
  EXPECT_EQ(read_file(path("v.npy")), known);
}

TEST_F(Output, FileIsReplacedAsAWholeOrNotAtAll) {
  write_file(path("out.csv"), "old");
  ::chmod(path("out.csv").c_str(), 0640);
  EXPECT_EQ(shell(kBad + kTwo + "-o " + path("out.csv")).exit_code, 2);
  EXPECT_EQ(read_file(path("out.csv")), "old");
  // An error that shows in the middle, when results have been written already.
  std::string csv = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n";
  for (int i = 0; i < 700000; ++i) csv += "0,0,1,0,0,1\n";
  const auto late = shell(kEvaluate + "--pairs - -o " + path("out.csv"), csv + "0,0,1,0,0,x\n");
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_THAT(late.err, HasSubstr(":700002, column 6"));
  EXPECT_EQ(read_file(path("out.csv")), "old");
  EXPECT_EQ(listing(), "out.csv\n");
  EXPECT_EQ(shell(kEvaluate + kTwo + "-o " + path("out.csv")).exit_code, 0);
  EXPECT_THAT(read_file(path("out.csv")), StartsWith("f_0,f_1,flags\n"));
  struct stat info {};
  ASSERT_EQ(::stat(path("out.csv").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777U, 0640U);
  EXPECT_EQ(listing(), "out.csv\n");
}

TEST_F(Output, SymbolicLinksAndDevicesStayWhatTheyAre) {
  write_file(path("target.csv"), "old");
  std::filesystem::create_symlink("target.csv", path("link.csv"));
  EXPECT_EQ(shell(kEvaluate + kTwo + "-o " + path("link.csv")).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(path("link.csv")));
  EXPECT_THAT(read_file(path("target.csv")), StartsWith("f_0"));
  EXPECT_EQ(shell(kEvaluate + kTwo + "-o /dev/null").exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_THAT(shell(kEvaluate + kTwo + "-o /dev/stdout").out, StartsWith("f_0"));
}

TEST_F(Output, WhatCannotBeWritten) {
  const auto folder = shell(kEvaluate + kTwo + "-o " + path("nowhere/out.csv"));
  EXPECT_EQ(folder.exit_code, 1);
  EXPECT_THAT(folder.err, AllOf(HasSubstr("nowhere/out.csv"), HasSubstr("No such file")));
  const auto full = shell(kEvaluate + kTwo + "> /dev/full");
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, HasSubstr("No space left"));
}

TEST_F(Output, ReaderThatGoesAwayIsNoFailure) {
  const auto result =
      shell("set -o pipefail; " + kEvaluate + "--grid theta_i=0:1:1000,theta_o=0:1:1000 | head -2");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "f_0,f_1,flags\n0.159154937,0.0795774683,0\n");
  EXPECT_THAT(result.err, IsEmpty());
}

TEST_F(Output, InterruptLeavesNothingBehind) {
  std::filesystem::create_directory(path("out"));
  const std::string out = path("out");
  // The input stays open, so that the tool waits with its temporary file at hand.
  const auto result =
      shell("mkfifo " + path("in") + "; exec 3<>" + path("in") +
            "; echo wi_x,wi_y,wi_z,wo_x,wo_y,wo_z >&3; " GONIO_PROGRAM
            " evaluate --material '{\"model\": \"ggx\"}' --pairs " +
            path("in") + " -o " + out + "/v.csv & pid=$!; " + "until [ -n \"$(ls -A " + out +
            ")\" ]; do sleep 0.05; done; " + "kill -TERM $pid; wait $pid; echo $?; ls -A " + out);
  EXPECT_EQ(result.out, "143\n") << result.err;
}

TEST_F(Output, VerboseReportsOnStandardError) {
  const auto result = shell(kEvaluate + "--grid theta_i=0 -v --isa baseline");
  EXPECT_EQ(lines_of(result.out).size(), 2U);
  EXPECT_THAT(result.err,
              MatchesRegex("gonio: 1 pairs x 2 channels in .* s \\(.* M pairs/s\\); kernels .* s; "
                           "baseline, fast, relative error <= .* where f > .*\n"));
}

TEST_F(Output, WhatDoesNotGoTogether) {
  EXPECT_EQ(shell(kEvaluate + kTwo + "--with-input --format npy").exit_code, 2);
  EXPECT_EQ(shell(kEvaluate + kTwo + "--with-input --format json").exit_code, 2);
}

TEST_F(Output, ResultsCanBeReadAgainAsInput) {
  const auto first = shell(kEvaluate + "--grid theta_i=0:1:5,theta_o=0:1:5 --with-input");
  const auto again = shell(kEvaluate + "--pairs - --with-input", first.out);
  EXPECT_EQ(again.out, first.out) << again.err;
}

}  // namespace
}  // namespace gonio::test
