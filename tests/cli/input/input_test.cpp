// What `gonio evaluate` reads: pairs as CSV and NPY, grids, materials; and what it says when they
// are wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/npy_file.h"
#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kEvaluate =
    R"(gonio evaluate --material '{"model": "lambertian", "parameters": {"rd": [0.5, 0.25]}}' )";
const std::string kHeader = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n";
const std::string kLit = "0.159154937,0.0795774683,0";

TEST(CsvInput, DirectionsFromFileAndFromStandardInput) {
  const gonio::testing::TempFolder folder;
  const std::string csv = kHeader + "0,0,1,0.6,0,0.8\n0,0,-1,0.6,0,0.8\n";
  write_file(folder / "pairs.csv", csv);
  const std::string expected = "f_0,f_1,flags\n" + kLit + "\n0,0,8\n";
  const auto file = shell(kEvaluate + "--pairs " + (folder / "pairs.csv").string());
  EXPECT_EQ(file.exit_code, 0) << file.err;
  EXPECT_EQ(file.out, expected);
  EXPECT_EQ(file.err,
            "gonio: 1 of 2 pairs is flagged and has the value 0: 1 wi below the horizon\n");
  EXPECT_EQ(shell(kEvaluate + "--pairs -", csv).out, expected);
  EXPECT_THAT(shell(kEvaluate + "--quiet --pairs -", csv).err, IsEmpty());
}

TEST(CsvInput, WhatItPutsUpWith) {
  const std::vector<std::string> files = {
      kHeader + "0,0,1,0.6,0,0.8",                               // no end of line
      "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\r\n0,0,1,0.6,0,0.8\r\n",    // Windows
      "\xEF\xBB\xBF" + kHeader + "\n 0, 0 ,1,\t0.6,0,+0.8\n\n",  // Excel, blanks, empty lines
      "id,wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,note\n7,0.6,0,0.8,1e-60,0,1e0,hello\n",  // other order,
                                                                                 // other columns
  };
  for (const auto& file : files) {
    const auto result = shell(kEvaluate + "--pairs -", file);
    EXPECT_EQ(result.out, "f_0,f_1,flags\n" + kLit + "\n") << result.err;
  }
}

TEST(CsvInput, BadNumbersThatAreNumbersAreFlagged) {
  const auto result =
      shell(kEvaluate + "--pairs -", kHeader +
                                         "nan,0,1,0,0,1\n0,0,1,0,0,1\n0,0,1,inf,0,1\n0,0,0,0,0,1\n"
                                         "0,0,2,0,0,1\n0,0,1e300,0,0,1\n");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "f_0,f_1,flags\n0,0,2\n" + kLit + "\n0,0,2\n0,0,4\n0,0,1\n0,0,2\n");
  EXPECT_THAT(result.err, AllOf(HasSubstr("5 of 6 pairs"), HasSubstr("3 not finite"),
                                HasSubstr("1 zero"), HasSubstr("1 not unit")));
}

TEST(CsvInput, AnglesAgreeWithTheGrid) {
  std::string csv = "theta_i,phi_i,theta_o,phi_o\n";
  for (const char* theta_i : {"0", "45", "90"}) {
    for (const char* theta_o : {"10", "60", "90"})
      csv += std::string(theta_i) + ",20," + theta_o + ",70\n";
  }
  const std::string ggx =
      R"(gonio evaluate -m '{"model": "ggx"}' --deg --precision reference --with-input )";
  const auto pairs = shell(ggx + "--pairs -", csv);
  const auto grid = shell(ggx + "--grid theta_i=0:90:3,phi_i=20,theta_o=10/60/90,phi_o=70");
  EXPECT_EQ(pairs.exit_code, 0) << pairs.err;
  EXPECT_EQ(pairs.out, grid.out);
  EXPECT_THAT(grid.out, HasSubstr("theta_i,phi_i,theta_o,phi_o,f_0,flags\n0,20,10,70,"));
  EXPECT_THAT(grid.out, HasSubstr("\n90,20,90,70,0,24\n"));
}

TEST(CsvInput, ErrorsNameFileLineColumnAndValue) {
  const auto error = [](const std::string& csv) {
    const auto result = shell(kEvaluate + "--pairs -", csv);
    EXPECT_EQ(result.exit_code, 2) << csv;
    EXPECT_THAT(lines_of(result.err).size(), 1U);
    return result.err;
  };
  EXPECT_THAT(error(kHeader + "0,0,1,0,0,1\n0,0,one,0,0,1\n"),
              HasSubstr("standard input:3, column 3 (wi_z): 'one' is not a number"));
  EXPECT_THAT(error(kHeader + "0,0,1,0,0,1x\n"), HasSubstr(":2, column 6 (wo_z): '1x'"));
  EXPECT_THAT(error(kHeader + "0,0,,0,0,1\n"), HasSubstr(":2, column 3 (wi_z): ''"));
  EXPECT_THAT(error(kHeader + "0,0,1,0,0\n"),
              HasSubstr(":2: fewer than the 6 columns of the header (5)"));
  EXPECT_THAT(error(kHeader + "0,0,1,0,0,1,2\n"), HasSubstr(":2: more than the 6 columns"));
  EXPECT_THAT(error("wi_x,wi_y,wi_z,wo_x,wo_y\n"),
              AllOf(HasSubstr(":1: "), HasSubstr("wi_x,wi_y,wi_z,wo_x,wo_y,wo_z")));
  EXPECT_THAT(error("0,0,1,0,0,1\n"), HasSubstr(":1: "));
  EXPECT_THAT(error("wi_x,wi_x," + kHeader), HasSubstr("twice"));
  EXPECT_THAT(error(""), HasSubstr("empty"));
  EXPECT_THAT(error(std::string(3 << 20, 'x')), HasSubstr("not CSV"));
  const auto missing = shell(kEvaluate + "--pairs nowhere.csv");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.csv cannot be read: No such file"));
  EXPECT_EQ(shell(kEvaluate + "--pairs /").exit_code, 2);
}

TEST(CsvInput, HeaderAloneGivesAHeader) {
  EXPECT_EQ(shell(kEvaluate + "--pairs -", kHeader).out, "f_0,f_1,flags\n");
  EXPECT_THAT(shell(kEvaluate + "--pairs - --format json", kHeader).out,
              HasSubstr("\"values\": [\n]"));
}

TEST(NpyInput, FloatsAndDoubles) {
  const std::string expected = "f_0,f_1,flags\n" + kLit + "\n0,0,16\n";
  const std::vector<float> floats = {0, 0, 1, 0.6F, 0, 0.8F, 0, 0, 1, 0.6F, 0, -0.8F};
  const std::vector<double> doubles = {0, 0, 1, 0.6, 0, 0.8, 0, 0, 1, 0.6, 0, -0.8};
  EXPECT_EQ(shell(kEvaluate + "--pairs -", npy("<f4", "False", "(2, 6)", bytes_of(floats))).out,
            expected);
  EXPECT_EQ(shell(kEvaluate + "--pairs -", npy("<f8", "False", "(2, 6)", bytes_of(doubles))).out,
            expected);
  const auto reference = shell(kEvaluate + "--precision reference --pairs -",
                               npy("<f8", "False", "(2,6)", bytes_of(doubles)));
  EXPECT_EQ(lines_of(reference.out)[1], "0.15915494309189535,0.079577471545947673,0")
      << reference.err;
  EXPECT_EQ(shell(kEvaluate + "--pairs -", npy("<f4", "False", "(0, 6)", "")).out,
            "f_0,f_1,flags\n");
}

TEST(NpyInput, Errors) {
  const std::string row = bytes_of(std::vector<float>{0, 0, 1, 0, 0, 1});
  const auto error = [](const std::string& file) {
    const auto result = shell(kEvaluate + "--pairs -", file);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  };
  EXPECT_THAT(error(npy("<f4", "False", "(2, 6)", row)), HasSubstr("ends after 1 of the 2 rows"));
  EXPECT_THAT(error(npy("<f4", "False", "(1, 6)", row + "x")),
              HasSubstr("goes on after the 1 rows"));
  EXPECT_THAT(error(npy("<i4", "False", "(1, 6)", row)), HasSubstr("type '<i4'"));
  EXPECT_THAT(error(npy(">f4", "False", "(1, 6)", row)), HasSubstr("type '>f4'"));
  EXPECT_THAT(error(npy("<f4", "True", "(1, 6)", row)), HasSubstr("Fortran order"));
  for (const char* shape : {"(1, 7)", "(6,)", "()", "(1, 6, 1)", "(99999999999999999999999, 6)"}) {
    EXPECT_THAT(error(npy("<f4", "False", shape, row)), HasSubstr(std::string("shape ") + shape));
  }
  EXPECT_THAT(error(npy("<f4", "False", "(1, 6)", row).substr(0, 50)),
              HasSubstr("ends within its header"));
  const std::string spaces = "{'descr':" + std::string(65526, ' ');
  EXPECT_THAT(error("\x93NUMPY" + std::string("\x01\x00\xff\xff", 4) + spaces),
              AllOf(HasSubstr("65535"), HasSubstr("at most 4096 bytes")));
  EXPECT_THAT(error("\x93NUMPY"), HasSubstr("header"));
  EXPECT_THAT(error("\x93NUMPY\x07__________________"), HasSubstr("version 7"));
}

TEST(GridInput, Errors) {
  const auto error = [](const std::string& spec) {
    const auto result = shell(kEvaluate + "--grid '" + spec + "'");
    EXPECT_EQ(result.exit_code, 2) << spec;
    EXPECT_THAT(result.out, IsEmpty());
    return result.err;
  };
  EXPECT_THAT(error("theta_i"), HasSubstr("'theta_i'"));
  EXPECT_THAT(error("theta_x=1"), HasSubstr("'theta_x=1'"));
  EXPECT_THAT(error("theta_i=1,"), HasSubstr("''"));
  EXPECT_THAT(error("theta_i="), HasSubstr("theta_i"));
  EXPECT_THAT(error("theta_i=1/x"), HasSubstr("'x'"));
  EXPECT_THAT(error("theta_i=nan"), HasSubstr("'nan'"));
  EXPECT_THAT(error("theta_i=0:1"), HasSubstr("START:STOP:COUNT"));
  EXPECT_THAT(error("theta_i=0:1:0"), HasSubstr("count of --grid theta_i is '0'"));
  EXPECT_THAT(error("theta_i=0:1:2.5"), HasSubstr("'2.5'"));
  EXPECT_THAT(error("theta_i=0:1:1"), HasSubstr("2 or more"));
  EXPECT_THAT(error("theta_i=1,theta_i=2"), HasSubstr("twice"));
  EXPECT_THAT(error("theta_i=1,theta_h=2"), HasSubstr("not both"));
  EXPECT_THAT(error("theta_i=0:1:1000000,theta_o=0:1:1000000"),
              AllOf(HasSubstr("1000000000000"), HasSubstr("at most 1000000000")));
  EXPECT_THAT(error("theta_i=0:1:99999999999999999999999"), HasSubstr("1 to 1000000"));
}

TEST(GridInput, NestsItsAxesLastFastest) {
  const auto result =
      shell(kEvaluate + "--deg --with-input --grid theta_o=0/10,theta_i=0:80:3,phi_o=0/180");
  const auto lines = lines_of(result.out);
  ASSERT_EQ(lines.size(), 13U) << result.err;
  EXPECT_EQ(lines[1], "0,0,0,0," + kLit);
  EXPECT_EQ(lines[2], "0,0,0,180," + kLit);
  EXPECT_EQ(lines[3], "0,0,10,0," + kLit);
  EXPECT_EQ(lines[12], "80,0,10,180," + kLit);
  const auto half =
      lines_of(shell(kEvaluate + "--deg --with-input --grid theta_h=0/10,phi_d=5").out);
  ASSERT_EQ(half.size(), 3U);
  EXPECT_EQ(half[0], "theta_h,theta_d,phi_d,f_0,f_1,flags");
  EXPECT_EQ(half[2], "10,0,5," + kLit);
}

TEST(MaterialInput, FilesAndErrors) {
  const gonio::testing::TempFolder folder;
  write_file(folder / "m.json", R"({"model": "lambertian", "parameters": {"rd": [0.5, 0.25]}})");
  write_file(folder / "broken.json", R"({"model": )");
  const auto with = [](const std::string& material) {
    return shell("gonio evaluate --grid theta_i=0 --material '" + material + "'");
  };
  EXPECT_EQ(with(folder / "m.json").out, "f_0,f_1,flags\n" + kLit + "\n");
  for (const auto& [material, message] : std::vector<std::pair<std::string, std::string>>{
           {folder / "broken.json", "broken.json"},
           {"nowhere.json", "no such file: nowhere.json"},
           {"./nowhere", "no such file: ./nowhere"},
           {"/", "is a folder"},
           {"nobody", "no material \"nobody\" is stored; allowed without --server: inline JSON"},
           {"ggx", R"('{"model": "ggx"}')"},
           {"", "empty"},
           {R"({"modell": "ggx"})", "modell"},
           {R"({"model": "measured", "parameters": {"file": 3}})",
            "material.parameters.file is a number"},
           {R"({"model": "measured", "parameters": {"file": ""}})",
            "material.parameters.file is not given"},
           {R"({"model": "gggx"})", "gggx"},
           {R"({"model": "ggx", "parameters": {"alpha_x": 7}})",
            "material.parameters.alpha_x is 7"},
           {R"({"model": "ggx", "parameters": {"gloss": 7}})", "gloss"}}) {
    const auto result = with(material);
    EXPECT_EQ(result.exit_code, 2) << material;
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_THAT(result.out, IsEmpty());
  }
}

}  // namespace
}  // namespace gonio::test
