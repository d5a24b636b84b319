// Wrong names of commands, options, models, words, keys and materials: what the tool asks for in
// their place. Substances as materials, and where a material may come from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"
#include "cli/support/socket_server.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kGold =
    R"({"model": "ggx", "parameters": {"f0": [1, 0.71, 0.29], "alpha_x": 0.2, "alpha_y": 0.2}})";
const std::string kGrid = " --grid theta_i=0.5,theta_o=0/0.4";

class Names : public ::testing::Test {
 protected:
  void SetUp() override {
    write_file(folder_ / "gold.json", kGold);
    write_file(folder_ / "gold.jsn", kGold);
    write_file(folder_ / "data.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0.1,0,0.2,1,0.3\n");
  }
  [[nodiscard]] Finished run(const std::string& line, const std::string& input = {}) const {
    return shell("cd '" + (folder_ / "").string() + "' && " + line, input);
  }
  // What is said of a line that is wrong input.
  [[nodiscard]] std::string said(const std::string& line) const {
    const auto result = run(line);
    EXPECT_EQ(result.exit_code, 2) << line << "\n" << result.err;
    EXPECT_THAT(result.out, IsEmpty()) << line;
    EXPECT_THAT(result.err, StartsWith("gonio: error: ")) << line;
    return result.err;
  }

  gonio::testing::TempFolder folder_;
};

TEST_F(Names, TheNearestIsAskedFor) {
  const std::string material = "gonio evaluate" + kGrid + " -m ";
  const std::pair<std::string, const char*> cases[] = {
      {"gonio rendr", "mean \"render\"?"},
      {"gonio Evaluate", "mean \"evaluate\"?"},
      {"gonio help", "mean \"--help\"?"},
      {"gonio --verison", "mean \"--version\"?"},
      {"gonio evaluate --materal gold.json", "mean \"--material\"?"},
      {"gonio evaluate --material=gold.json --gird=theta_i=0", "mean \"--grid\"?"},
      {"gonio render --material gold.json --shap plane -o a.png", "mean \"--shape\"?"},
      {"gonio render --material gold.json --shape spher -o a.png", "mean \"sphere\"?"},
      {"gonio render --material gold.json --light Sky -o a.png", "mean \"sky\"?"},
      {"gonio lobe --theta 30 -m gold.json --scale liner -o a.png", "mean \"linear\"?"},
      {material + "gold.json --precision refrence", "mean \"reference\"?"},
      {material + "gold.json --isa avx_512", "mean \"avx512\"?"},
      {material + R"('{"model": "GGX"}')", "mean \"ggx\"?"},
      {material + R"('{"model": "cook-torrance"}')", "mean \"cook_torrance\"?"},
      {material + R"('{"model": "ggx", "parametrs": {}}')", "mean \"parameters\"?"},
      {material + R"('{"model": "ggx", "parameters": {"alphax": 1}}')", "mean \"alpha_x\"?"},
      {material + R"('{"model": "ggx", "parameters": {"fresnel": "shlick"}}')",
       "mean \"schlick\"?"},
      {material + R"('{"model": "ggx", "parameters": {"f0": "coper"}}')", "mean \"copper\"?"},
      {material + R"('{"model": "ggx", "parameters": {"f0": "gold"}}')",
       R"("eta": "gold", "k": "gold")"},
      {material + R"('{"model": "oren_nayar", "parameters": {"sigma": 30}}')",
       "30 degrees are 0.5235"},
      {material + R"('{"name": "coper"}')", "mean \"copper\"?"},
      {material + "coper", "mean \"copper\"?"},
      {material + "gol.json", "mean \"gold.json\"?"},
      {material + "./glod.json", "mean \"gold.json\"?"},
      {"gonio evaluate -m gold.json --grid theta_j=0", "mean \"theta_i\"?"},
      {"gonio models GGX", "mean \"ggx\"?"},
      {"gonio fit --data dat.csv --model ggx", "mean \"data.csv\"?"},
      {"gonio evaluate -m gold.json --pairs dta.csv", "mean \"data.csv\"?"},
      {"gonio fit --data data.csv --model gxx", "mean \"ggx\"?"},
      {"gonio fit --data data.csv --model ggx:shlick", "mean \"schlick\"?"},
      {"gonio fit --data data.csv --model ggx --base Lambertian", "mean \"lambertian\"?"},
      {"gonio fit --data data.csv --model ggx --objective l3", "mean \"l1\"?"},
      {"gonio chart -o chart --parts wires", "mean \"wire\"?"},
      {"gonio completion bahs", "mean \"bash\"?"},
  };
  for (const auto& [line, asked] : cases) EXPECT_THAT(said(line), HasSubstr(asked)) << line;
}

TEST_F(Names, ScenesAndCostsToo) {
  const auto of_scene = [&](const std::string& scene, const std::string& more = {}) {
    write_file(folder_ / "scene.json", scene);
    return said("gonio select --reference gold.json --scene scene.json" + more);
  };
  const std::string ranges = R"({"theta_i": [0, 60], "theta_o": [0, 75], )";
  EXPECT_THAT(of_scene(ranges + R"("tolerence": 0.1})"), HasSubstr("mean \"tolerance\"?"));
  EXPECT_THAT(of_scene(ranges + R"("tolerance": 0.1, "metric": "deltae"})"),
              HasSubstr("mean \"delta_e\"?"));
  EXPECT_THAT(of_scene(ranges + R"("tolerance": 0.1, "cost": "byte"})"),
              HasSubstr("mean \"bytes\"?"));
  EXPECT_THAT(of_scene(ranges + R"("tolerance": 0.1, "lights": "Directional"})"),
              HasSubstr("mean \"directional\"?"));
  write_file(folder_ / "costs.json", R"({"lambertain": 1})");
  EXPECT_THAT(of_scene(ranges + R"("tolerance": 0.1})", " --costs costs.json"),
              AllOf(HasSubstr("without \"lambertian\""), HasSubstr("\"lambertain\"")));
}

TEST_F(Names, WhatIsNotLikeAnythingIsNotAskedFor) {
  for (const char* line : {"gonio qqqqqq", "gonio evaluate --qqqqqq 1", "gonio models qqqqqq"})
    EXPECT_THAT(said(line), Not(HasSubstr("did you mean"))) << line;
}

TEST_F(Names, AFileWithoutAnOptionIsOfferedToOne) {
  EXPECT_THAT(said("gonio render gold.json -o a.png"),
              AllOf(HasSubstr("\"gold.json\" is not an argument of 'gonio render'"),
                    HasSubstr("mean \"--material gold.json\"?"), HasSubstr("gonio render --help")));
  EXPECT_THAT(said("gonio fit data.csv --model ggx"), HasSubstr("mean \"--data data.csv\"?"));
  EXPECT_THAT(said("gonio compare data.csv"), HasSubstr("mean \"--reference data.csv\"?"));
  EXPECT_THAT(said("gonio gold.json"), HasSubstr("a command must come first"));
  EXPECT_THAT(said("gonio models a b"), HasSubstr("\"b\" is not an argument of 'gonio models'"));
}

// A surface of GGX with the index of the metal, or the reflectance of what is no metal.
TEST_F(Names, ASubstanceIsAMaterial) {
  const auto same = [&](const std::string& name, const std::string& json) {
    const auto short_form = run("gonio evaluate -m " + name + kGrid);
    EXPECT_EQ(short_form.exit_code, 0) << short_form.err;
    EXPECT_EQ(short_form.out, run("gonio evaluate -m '" + json + "'" + kGrid).out) << name;
  };
  same("copper", R"({"model": "ggx", "parameters": {"eta": "copper", "k": "copper"}})");
  same("water", R"({"model": "ggx", "parameters": {"f0": "water"}})");
  for (const char* line :
       {"gonio albedo -m copper --theta 30 --count 100",
        "gonio sample -m gold --wi 0,0,1 --count 2",
        "gonio lobe -m silver --theta 30 --size 200x200 -o a.png",
        "gonio render -m iron --size 8x8 --spp 1 -o b.png",
        "gonio compare --reference data.csv -m plastic", "gonio assess -m copper --pairs 10 -q"}) {
    const auto result = run(line);
    if (std::string_view(line).find("plastic") != std::string_view::npos) {
      EXPECT_THAT(result.err, HasSubstr("3 channels")) << line;  // of a reference of one
    } else {
      EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 4) << line << result.err;
    }
  }
}

TEST_F(Names, AFileAndAStoredMaterialComeBeforeASubstance) {
  const std::string grey = R"({"model": "lambertian", "parameters": {"rd": 0.5}})";
  const SocketServer server{{{"copper", grey}}};
  const std::string at = " --server " + server.address() + " --grid theta_i=0";
  EXPECT_EQ(run("gonio evaluate -m copper" + at).out, "f_0,flags\n0.159154937,0\n");
  EXPECT_EQ(lines_of(run("gonio evaluate -m gold" + at).out).at(0), "f_0,f_1,f_2,flags");
  write_file(folder_ / "gold", grey);
  EXPECT_EQ(run("gonio evaluate -m gold" + at).out, "f_0,flags\n0.159154937,0\n");
  write_file(folder_ / "gold", "no material");
  EXPECT_EQ(lines_of(run("gonio evaluate -m gold" + at).out).at(0), "f_0,f_1,f_2,flags");
}

TEST_F(Names, AMaterialComesFromStandardInputAndFromAnyFile) {
  const std::string usual = run("gonio evaluate -m gold.json" + kGrid).out;
  EXPECT_EQ(lines_of(usual).size(), 3U);
  EXPECT_EQ(run("gonio evaluate -m -" + kGrid, kGold).out, usual);
  EXPECT_EQ(run("gonio evaluate -m @gold.json" + kGrid).out, usual);
  write_file(folder_ / "gold", kGold);
  EXPECT_EQ(run("gonio evaluate -m @gold" + kGrid).out, usual);
  EXPECT_EQ(run("gonio evaluate -m gold.jsn" + kGrid).out, usual);
  EXPECT_THAT(said("gonio evaluate -m - --pairs -"),
              AllOf(HasSubstr("--pairs is -"), HasSubstr("--material reads")));
  EXPECT_THAT(said("gonio evaluate -m @none.json" + kGrid), HasSubstr("no such file: none.json"));
}

}  // namespace
}  // namespace gonio::test
