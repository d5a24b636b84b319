// `gonio select` as users and pipelines see it: tables, files, errors, the exit status.
#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include "cli/run_process.h"
#include "select/prices.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

google::protobuf::Struct json(const std::string& text) {
  google::protobuf::Struct parsed;
  EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(text, &parsed).ok()) << text;
  return parsed;
}

constexpr const char* kGrey = R"({"model": "lambertian", "parameters": {"rd": [0.5, 0.4, 0.3]}})";
constexpr const char* kGloss =
    R"({"diffuse": {"model": "lambertian", "parameters": {"rd": 0.4}}, "specular": [{"model": "ggx", "parameters": {"alpha_x": 0.3, "alpha_y": 0.3, "eta": 1.5}}]})";

// Scenes, materials and prices in a folder; `gonio select` within it.
class SelectCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string prices;
    for (const auto& [part, ns] : gonio::testing::prices_of_all_parts())
      prices += (prices.empty() ? "{\"" : ", \"") + part + "\": " + std::to_string(ns);
    write("costs.json", prices + ", \"reference\": 40}");
    write("scene.json",
          R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.6, "anisotropy": false})");
    write("grey.json", kGrey);
    write("gloss.json", kGloss);
  }
  void write(const std::string& name, const std::string& content) {
    write_file(folder_ / name, content);
  }
  Finished select(const std::string& arguments) {
    return shell("cd '" + (folder_ / "").string() +
                 "' && gonio select --costs costs.json --lobes 1 " + arguments);
  }
  // Of a scene file with this content.
  std::string refused(const std::string& scene, const std::string& arguments = "") {
    write("bad.json", scene);
    const auto result = select("--reference grey.json --scene bad.json " + arguments);
    EXPECT_EQ(result.exit_code, 2) << scene;
    EXPECT_THAT(result.out, IsEmpty());
    return result.err;
  }

  gonio::testing::TempFolder folder_;
};

TEST_F(SelectCommand, PrintsTheFrontAndWritesTheChoice) {
  const auto result =
      select("--reference gloss.json --scene scene.json --all -o out.json --report r.json");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_THAT(result.out, AllOf(HasSubstr("candidate"), HasSubstr("\n* "), HasSubstr("chosen"),
                                HasSubstr("the tolerance is 0.6"), HasSubstr("no better than"),
                                HasSubstr("oren_nayar:full")));
  EXPECT_TRUE(json(read_file(folder_ / "out.json")).fields().contains("model"));
  const auto report = json(read_file(folder_ / "r.json"));
  EXPECT_EQ(report.fields().at("choice").struct_value().fields().at("confidence").number_value(),
            0.975);
  EXPECT_GE(report.fields().at("entries").list_value().values_size(), 20);
}

// The same through a server, and by the name of a material that it holds.
TEST_F(SelectCommand, AsksAServer) {
  const auto result = shell(
      "cd '" + (folder_ / "").string() +
      "' && gonio select --costs costs.json --no-front --reference grey.json --scene scene.json "
      "--server unix:nobody.sock");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("nobody.sock"));
}

TEST_F(SelectCommand, SelectsForAllMaterialsOfAScene) {
  write("many.json", R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.6,
    "anisotropy": false, "materials": {"wall": {"reference": "grey.json"},
    "car": {"reference": "gloss.json", "tolerance": 0.03}, "floor": {"reference": )" +
                         std::string(kGrey) + R"(, "theta_o": [0, 20]}}})");
  const auto result = select("--no-front --scene many.json -o chosen --report r.json");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("\nwall "), HasSubstr("\ncar "), HasSubstr("\nfloor "),
                                HasSubstr("Saved: an evaluation of each costs "),
                                HasSubstr("instead of 120"), HasSubstr("car: lambertian + ")));
  for (const char* name : {"wall", "car", "floor"}) {
    EXPECT_FALSE(
        json(read_file(folder_ / "chosen" / (std::string(name) + ".json"))).fields().empty());
    EXPECT_TRUE(json(read_file(folder_ / "r.json")).fields().contains(name));
  }
  EXPECT_THAT(read_file(folder_ / "chosen" / "wall.json"), HasSubstr("lambertian"));
  EXPECT_THAT(read_file(folder_ / "chosen" / "car.json"), HasSubstr("specular"));
}

TEST_F(SelectCommand, NothingGoodEnoughHasAnExitStatusOfItsOwn) {
  // Pairs that no model follows.
  std::string rows = "theta_i,phi_i,theta_o,phi_o,f_0\n";
  for (int i = 0; i < 2000; ++i)
    rows += std::to_string(i % 7 * 0.1) + ",0," + std::to_string(i % 11 * 0.1) + "," +
            std::to_string(i % 13 * 0.4) + "," + std::to_string(i % 5) + "\n";
  write("noise.csv", rows);
  const auto result = select("--reference noise.csv --scene scene.json -o out.json");
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_THAT(result.out, HasSubstr("no candidate meets the tolerance of 0.6"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.json"));
}

TEST_F(SelectCommand, ScenesThatAreNone) {
  EXPECT_THAT(refused(""), HasSubstr("bad.json, which is empty; allowed: a JSON object"));
  EXPECT_THAT(refused("  \n"), HasSubstr("which is empty"));
  EXPECT_THAT(refused("{}"), HasSubstr("scene is empty; allowed: ranges theta_i and theta_o"));
  EXPECT_THAT(refused("[]"), HasSubstr("which does not begin with {; allowed: a JSON object"));
  EXPECT_THAT(refused(R"({"theta_i": [0, 60], "theta_o": [0, 75]})"),
              HasSubstr("scene.tolerance is not given; allowed: a number above 0"));
  std::filesystem::create_directory(folder_ / "folder.json");
  const auto folder = select("--reference grey.json --scene folder.json");
  EXPECT_EQ(folder.exit_code, 2);
  EXPECT_THAT(folder.err, HasSubstr("scene is folder.json; allowed: a JSON file that can be read"));
  EXPECT_THAT(refused(R"({"tolerance": 0.1})"), HasSubstr("scene is empty"));
  EXPECT_THAT(refused(R"({"theta_i": [0, 60], "tolerance": 0.1})"),
              HasSubstr("scene.theta_o is not given; allowed: [lower, upper] in degrees"));
  EXPECT_THAT(select("--reference grey.json --scene nowhere.json").err,
              HasSubstr("scene is nowhere.json"));
}

TEST_F(SelectCommand, RangesThatContradict) {
  const auto with = [&](const std::string& fields) {
    return refused(R"({"tolerance": 0.1, )" + fields + "}");
  };
  EXPECT_THAT(
      with(R"("theta_i": [60, 20], "theta_o": [0, 75])"),
      HasSubstr("scene.theta_i is [60, 20]; allowed: from 0 to 90 degrees, the first below"));
  EXPECT_THAT(with(R"("theta_i": [0, 60], "theta_o": [30, 30])"),
              HasSubstr("scene.theta_o is [30, 30]"));
  EXPECT_THAT(with(R"("theta_i": [0, 60], "theta_o": [0, 95])"),
              HasSubstr("scene.theta_o is [0, 95]"));
  EXPECT_THAT(with(R"("theta_i": [-5, 60], "theta_o": [0, 75])"),
              HasSubstr("scene.theta_i is [-5, 60]"));
  EXPECT_THAT(with(R"("theta_i": [0, 60], "theta_o": [0, 75], "phi": [90, 200])"),
              HasSubstr("scene.phi is [90, 200]"));
  EXPECT_THAT(with(R"("theta_i": [0], "theta_o": [0, 75])"), HasSubstr("two numbers"));
  EXPECT_THAT(with(R"("theta_i": [0, "x"], "theta_o": [0, 75])"), HasSubstr("allowed: numbers"));
  EXPECT_THAT(with(R"("theta_i": [0, 60], "histogram": {})"), HasSubstr("ranges or a histogram"));
  EXPECT_THAT(
      with(
          R"("histogram": {"theta_i": [0, 90], "theta_o": [90, 0], "phi": [0, 180], "counts": [1]})"),
      HasSubstr("scene.histogram.theta_o"));
  EXPECT_THAT(
      with(
          R"("histogram": {"theta_i": [0, 90], "theta_o": [0, 90], "phi": [0, 180], "counts": [0]})"),
      HasSubstr("scene.histogram.counts"));
}

TEST_F(SelectCommand, NamesThatWouldLeaveTheFolder) {
  const auto error_of = [&](const std::string& name, const std::string& output) {
    write("all.json",
          R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.1, "materials": {")" + name +
              R"(": {"reference": "grey.json"}}})");
    const auto result = select("--scene all.json -o " + output);
    EXPECT_EQ(result.exit_code, 2) << name;
    return result.err;
  };
  for (const std::string name : {"../b", "c/d", "", "..", "."})
    EXPECT_THAT(error_of(name, "chosen"), HasSubstr('"' + name + "\" as a name"));
  EXPECT_THAT(error_of(std::string(201, 'n'), "chosen"), HasSubstr("1 to 200 bytes"));
  EXPECT_THAT(error_of("a\\u0000b", "chosen"), HasSubstr("a\\u0000b\" as a name"));
  EXPECT_THAT(error_of("a", "-"),
              HasSubstr("--output is -, for materials by name; allowed: a folder"));
}

TEST_F(SelectCommand, ValuesThatAreNotKnown) {
  const auto with = [&](const std::string& field) {
    return refused(R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.1, )" + field + "}");
  };
  for (const char* metric : {"L1", "l1 ", "l2", "rms", "delta_E", "deltae"}) {
    EXPECT_THAT(with(R"("metric": ")" + std::string(metric) + "\""),
                HasSubstr("scene.metric is \"" + std::string(metric) +
                          "\"; allowed: l1, rmse, log, cbrt, delta_e"));
  }
  EXPECT_THAT(with(R"("metric": 1)"), HasSubstr("scene.metric is \"1\""));
  EXPECT_THAT(with(R"("cost": "time")"), HasSubstr("allowed: ns, bytes, ns_variance"));
  EXPECT_THAT(with(R"("cost": "ns_variance")"), HasSubstr("directional"));
  EXPECT_THAT(with(R"("lights": "sun")"), HasSubstr("allowed: directional, environment"));
  EXPECT_THAT(with(R"("toleranse": 0.1)"), HasSubstr("scene.toleranse is not a field"));
  EXPECT_THAT(with(R"("anisotropy": 0)"), HasSubstr("true or false"));
  EXPECT_THAT(with(R"("confidence": 1)"),
              HasSubstr("scene.confidence is 1; allowed: 0.5 to 0.9999"));
  for (const char* tolerance : {"0", "-0.1"}) {
    EXPECT_THAT(refused(R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": )" +
                        std::string(tolerance) + "}"),
                HasSubstr("scene.tolerance is " + std::string(tolerance) + "; allowed: above 0"));
  }
}

TEST_F(SelectCommand, MaterialsThatAreNone) {
  const auto many = [&](const std::string& materials) {
    write("many.json",
          R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.6, "materials": )" +
              materials + "}");
    const auto result = select("--scene many.json");
    EXPECT_EQ(result.exit_code, 2) << materials;
    return result.err;
  };
  EXPECT_THAT(many("{}"), HasSubstr("scene.materials is {}"));
  EXPECT_THAT(many(R"({"car": {}})"), HasSubstr("car: reference is not given"));
  EXPECT_THAT(many(R"({"car": {"reference": "grey.json", "metric": "L1"}})"),
              HasSubstr("car: scene.metric is \"L1\""));
  EXPECT_THAT(many(R"({"car": {"reference": "grey.json", "tolerance": 0}})"),
              HasSubstr("car: scene.tolerance is 0"));
  EXPECT_THAT(many(R"({"car": {"reference": "nowhere.json"}})"), HasSubstr("car: "));
  EXPECT_THAT(many(R"({"car": {"file": "x"}})"), HasSubstr("car: file is not a field"));
  EXPECT_THAT(select("--scene scene.json").err, HasSubstr("or --reference"));
  EXPECT_THAT(select("--scene many.json --reference grey.json").err, HasSubstr("one of both"));
}

TEST_F(SelectCommand, ReferencesThatAreNone) {
  std::string rows = "theta_i,phi_i,theta_o,phi_o,f_0\n";
  for (int i = 0; i < 500; ++i) rows += "0.2,0,0.3,1,nan\n";
  write("nan.csv", rows);
  const auto nan = select("--reference nan.csv --scene scene.json");
  EXPECT_EQ(nan.exit_code, 2);
  EXPECT_THAT(nan.err, AllOf(HasSubstr("reference is 0 usable pairs of 500 (500 not finite"),
                             HasSubstr("at least 200 within the scene's angles")));
  const auto missing = select("--reference nowhere.csv --scene scene.json");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.csv"));
  write("costs.json", R"({"lambertian": 1})");
  const auto poor = select("--reference grey.json --scene scene.json");
  EXPECT_EQ(poor.exit_code, 2);
  EXPECT_THAT(poor.err, HasSubstr("allowed: a number for every part"));
}

}  // namespace
}  // namespace gonio::test
