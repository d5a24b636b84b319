// Files of another kind than is asked for, endings that promise another format, and angles that
// look like degrees.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/support/run_process.h"
#include "client/cli/input/file_kind.h"
#include "measured/synthetic_merl.h"

namespace gonio::test {
namespace {

using cli::FileKind;
using cli::kind_of_content;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kGrey = R"({"model": "lambertian", "parameters": {"rd": 0.5}})";
const std::string kOther = std::string(GONIO_TEST_DATA) + "/other_kinds/";

class Kinds : public ::testing::Test {
 protected:
  void SetUp() override { write_file(folder_ / "grey.json", kGrey); }
  [[nodiscard]] Finished run(const std::string& line) const {
    return shell("cd '" + (folder_ / "").string() + "' && " + line);
  }
  [[nodiscard]] std::string said(const std::string& line) const {
    const auto result = run(line);
    EXPECT_EQ(result.exit_code, 2) << line << "\n" << result.err;
    return result.err;
  }
  gonio::testing::TempFolder folder_;
};

TEST(FileKind, IsKnownByTheContent) {
  const std::pair<std::string, FileKind> cases[] = {
      {kGrey, FileKind::material_json},
      {"\n {\"specular\": []}", FileKind::material_json},
      {R"({"theta_i": [0, 1], "tolerance": 1})", FileKind::scene_json},
      {R"({"other": 1})", FileKind::other_json},
      {"\x93NUMPY\x01", FileKind::npy},
      {std::string("tensor_file\0\1\0", 14), FileKind::rgl},
      {"#DIM 2 1\n0 0 1\n", FileKind::alta},
      {"Source  Measured\nScatterType  BRDF\n", FileKind::zemax},
      {"# Cornell University\n# Paint\n31\n", FileKind::cornell},
      {"4 2 2 1\n400 500\n", FileKind::unknown},
      {"theta_i,phi_i,theta_o,phi_o,f_0\n", FileKind::csv_values},
      {"wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n", FileKind::csv_pairs},
      {"\x89PNG\r\n", FileKind::picture},
      {"PK\x03\x04rest", FileKind::spreadsheet},
      {"\x1f\x8b\x08", FileKind::compressed},
      {"", FileKind::unknown},
      {"plain words", FileKind::unknown},
      {std::string("\0\1\2", 3), FileKind::unknown}};
  for (const auto& [content, kind] : cases)
    EXPECT_EQ(kind_of_content(content, content.size()), kind) << content;
}

TEST_F(Kinds, WhatIsNoMaterialSaysWhatTakesIt) {
  const std::string grid = " --grid theta_i=0";
  write_file(folder_ / "data.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0.1,0,0.2,1,0.3\n");
  EXPECT_THAT(said("gonio evaluate -m data.csv" + grid),
              AllOf(HasSubstr("directions and values as CSV, not a material"),
                    HasSubstr("gonio fit --data data.csv")));
  write_file(folder_ / "paper.bsdf", std::string("tensor_file\0\1\0", 14));
  EXPECT_THAT(said("gonio render -m paper.bsdf -o a.png"),
              AllOf(HasSubstr("the RGL database"), HasSubstr("gonio fit --data paper.bsdf")));
  EXPECT_THAT(said("gonio fit --model ggx --data " + kOther + "zemax_style.bsdf"),
              AllOf(HasSubstr("a Zemax BSDF text"), HasSubstr("CSV")));
  EXPECT_THAT(said("gonio fit --model ggx --data grey.json"),
              AllOf(HasSubstr("a material's JSON, not measured reflectance"),
                    HasSubstr("gonio evaluate --material grey.json")));
  EXPECT_THAT(said("gonio evaluate -m grey.json --pairs grey.json"),
              HasSubstr("a material's JSON, not directions"));
  write_file(folder_ / "scene.json", R"({"theta_i": [0, 1], "tolerance": 1})");
  EXPECT_THAT(said("gonio evaluate -m scene.json" + grid),
              HasSubstr("gonio select --scene scene.json"));
  write_file(folder_ / "book.xlsx", "PK\x03\x04");
  EXPECT_THAT(said("gonio fit --model ggx --data book.xlsx"), HasSubstr("save it as CSV"));
}

TEST_F(Kinds, NamesDoNotHideWhatAFileHolds) {
  ASSERT_TRUE(
      gonio::testing::write_merl(folder_ / "glossy.BINARY", gonio::testing::glossy_example));
  const auto capital = run("gonio evaluate -m glossy.BINARY --grid theta_i=0.3");
  EXPECT_EQ(capital.exit_code, 0) << capital.err;
  std::filesystem::rename(folder_ / "glossy.BINARY", folder_ / "glossy.dat");
  EXPECT_EQ(run("gonio evaluate -m glossy.dat --grid theta_i=0.3").out, capital.out);
  EXPECT_EQ(run("gonio compare --reference glossy.dat -m grey.json").exit_code, 0);
}

TEST_F(Kinds, EndingsOfOtherFormatsAreRefused) {
  const std::string material = " -m grey.json ";
  write_file(folder_ / "scene.json", R"({"theta_i": [0, 1], "theta_o": [0, 1], "tolerance": 1})");
  for (const std::string& line :
       {"gonio evaluate" + material + "--grid theta_i=0 -o x.xlsx",
        "gonio sample" + material + "--wi 0,0,1 --count 2 -o x.xlsx",
        "gonio albedo" + material + "--theta 30 -o x.xlsx",
        "gonio assess" + material + "--report x.xlsx",
        "gonio compare --reference " + kOther + "all_nan.csv" + material + "--report x.xlsx",
        "gonio fit --model ggx --data " + kOther + "all_nan.csv -o x.xlsx",
        "gonio fit --model ggx --data " + kOther + "all_nan.csv --report x.xlsx",
        std::string("gonio select --reference grey.json --scene scene.json -o x.xlsx"),
        std::string("gonio select --reference grey.json --scene scene.json --report x.xlsx")}) {
    EXPECT_THAT(said(line), AllOf(HasSubstr("\"x.xlsx\""), HasSubstr("a file that ends in ")));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.xlsx"));
  EXPECT_THAT(said("gonio evaluate" + material + "--grid theta_i=0 -o x.nyp"),
              HasSubstr("did you mean \".npy\"?"));
  for (const char* out : {"x", "x.CSV", "x.xlsx --format csv", "/dev/null"}) {
    const auto result = run("gonio evaluate" + material + "--grid theta_i=0 -o " + out);
    EXPECT_EQ(result.exit_code, 0) << out << result.err;
  }
}

TEST_F(Kinds, AnglesInDegreesGetAHint) {
  const std::string evaluate = "gonio evaluate -m grey.json ";
  const auto hint = AllOf(HasSubstr("gonio: note: "), HasSubstr("--deg"));
  EXPECT_THAT(run(evaluate + "--grid theta_o=40").err, AllOf(hint, HasSubstr("theta_o has 40")));
  EXPECT_THAT(run(evaluate + "--grid phi_o=0:360:5").err, HasSubstr("beyond 2 pi"));
  EXPECT_THAT(run(evaluate + "--grid theta_d=0/80").err, hint);
  EXPECT_THAT(run(evaluate + "--grid theta_o=40 --deg").err, IsEmpty());
  EXPECT_THAT(run(evaluate + "--grid theta_o=-1.5:1.5:3,phi_o=6.28").err, IsEmpty());
  write_file(folder_ / "pairs.csv", "theta_i,phi_i,theta_o,phi_o\n0.1,0,0.2,0\n30,0,40,180\n");
  const auto pairs = run(evaluate + "--pairs pairs.csv --with-input");
  EXPECT_THAT(pairs.err, AllOf(hint, HasSubstr("theta_i is 30")));
  EXPECT_THAT(pairs.out, HasSubstr("\n30,0,40,180,"));
  EXPECT_EQ(run(evaluate + "--pairs pairs.csv --with-input --deg").err, "");
  std::string data = "theta_i,phi_i,theta_o,phi_o,f_0\n";
  for (int i = 5; i < 80; i += 5)
    data += std::to_string(i) + ",0," + std::to_string(i) + ",180,0.3\n";
  write_file(folder_ / "data.csv", data);
  const std::string compare = "gonio compare --reference data.csv -m grey.json";
  EXPECT_THAT(run(compare).err, AllOf(hint, HasSubstr("below the horizon")));
  EXPECT_THAT(run(compare + " --deg").err, Not(HasSubstr("--deg")));
}

TEST_F(Kinds, AComparisonWithoutAUsablePairIsAnError) {
  EXPECT_THAT(said("gonio compare --deg -m grey.json --reference " + kOther + "all_nan.csv"),
              AllOf(HasSubstr("without a usable pair"), HasSubstr("1 not finite")));
  EXPECT_THAT(said("gonio fit --deg --model lambertian --data " + kOther + "all_nan.csv"),
              HasSubstr("no pair is left"));
  EXPECT_THAT(
      said("gonio chart --quick -q --parts fits -o chart --deg --data " + kOther + "all_nan.csv"),
      HasSubstr("without a usable pair"));
}

TEST_F(Kinds, TablesAreThereAsJson) {
  write_file(folder_ / "data.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0.1,0,0.2,1,0.3\n");
  const auto compared =
      run("gonio compare --reference data.csv -m grey.json --report r.json > table && cat r.json");
  EXPECT_THAT(compared.out, AllOf(HasSubstr("\"pairs\": 1"), HasSubstr("\"name\": \"grey.json\""),
                                  HasSubstr("\"above_80\": {\"pairs\": 0, \"l1\": null")));
  EXPECT_THAT(run("gonio albedo -m grey.json --theta 30 --count 100 --json").out,
              HasSubstr("\"albedos\": ["));
  EXPECT_EQ(run("gonio albedo -m grey.json --theta 30 --count 100 -o a.json").exit_code, 0);
  EXPECT_THAT(read_file(folder_ / "a.json"), HasSubstr("\"albedos\": ["));
  EXPECT_THAT(run("gonio models --presets --json").out,
              AllOf(HasSubstr("\"name\": \"gold\""), HasSubstr("\"partner\": \"k\"")));
}

}  // namespace
}  // namespace gonio::test
