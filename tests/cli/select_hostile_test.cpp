// Scenes, materials and references that `gonio select` cannot use: what it says of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/select_fixture.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SelectRefuses : public SelectCommand {
 protected:
  // Of a scene file with this content.
  std::string refused(const std::string& scene, const std::string& arguments = "") {
    write("bad.json", scene);
    const auto result = select("--reference grey.json --scene bad.json " + arguments);
    EXPECT_EQ(result.exit_code, 2) << scene;
    EXPECT_THAT(result.out, IsEmpty());
    return result.err;
  }
};

TEST_F(SelectRefuses, ScenesThatAreNone) {
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

TEST_F(SelectRefuses, RangesThatContradict) {
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

TEST_F(SelectRefuses, NamesThatWouldLeaveTheFolder) {
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

TEST_F(SelectRefuses, ValuesThatAreNotKnown) {
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

TEST_F(SelectRefuses, MaterialsThatAreNone) {
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

TEST_F(SelectRefuses, ReferencesThatAreNone) {
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
