// Materials with turned tangents as users meet them: evaluated, drawn, assessed, and found by fits.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/json_text.h"
#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const google::protobuf::Value& at(const google::protobuf::Struct& object, const std::string& name) {
  return object.fields().at(name);
}

class RotationCommand : public ::testing::Test {
 protected:
  // A shell line with $D for a folder that holds the material, turned by 35 degrees and not.
  [[nodiscard]] Finished run(const std::string& line) {
    const std::string brushed =
        R"("diffuse": {"model": "lambertian", "parameters": {"rd": 0.1}}, "specular": [{"model": "ggx",
           "parameters": {"f0": 0.6, "alpha_x": 0.1, "alpha_y": 0.4}}])";
    write_file(folder_ / "plain.json", "{" + brushed + "}");
    write_file(folder_ / "turned.json", "{" + brushed + R"(, "rotation": 35})");
    return shell("D='" + (folder_ / "").string() + "'; " + line);
  }
  [[nodiscard]] std::string content(const std::string& name) const {
    return read_file(folder_ / name);
  }

  gonio::testing::TempFolder folder_;
};

TEST_F(RotationCommand, TurnsWhatIsEvaluated) {
  const auto turned = run(
      "gonio evaluate -m $D/turned.json --deg --grid theta_i=40,phi_i=75,theta_o=0:80:9,phi_o=255");
  const auto plain = run(
      "gonio evaluate -m $D/plain.json --deg --grid theta_i=40,phi_i=40,theta_o=0:80:9,phi_o=220");
  ASSERT_EQ(turned.exit_code, 0) << turned.err;
  const auto a = lines_of(turned.out), b = lines_of(plain.out);
  ASSERT_EQ(a.size(), 10U);
  for (std::size_t i = 1; i < a.size(); ++i) {
    const double f = std::stod(b[i]);
    EXPECT_NEAR(std::stod(a[i]), f, 1e-5 * f) << a[i];
  }
  EXPECT_NE(run("gonio evaluate -m $D/turned.json --deg --grid "
                "theta_i=40,phi_i=40,theta_o=0:80:9,phi_o=220")
                .out,
            plain.out);
}

TEST_F(RotationCommand, IsAssessedAsAnyMaterial) {
  const auto result = run("gonio assess -m $D/turned.json --pairs 1001");
  EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("verdict: passed"));
}

TEST_F(RotationCommand, OutOfBoundsIsNamed) {
  const auto result = run(
      R"(gonio evaluate -m '{"model": "ggx", "rotation": 270}' --deg --grid theta_i=0,theta_o=0)");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("rotation is 270"), HasSubstr("[-180, 180]")));
}

TEST_F(RotationCommand, IsFoundByAFit) {
  const auto result =
      run("gonio evaluate -m $D/turned.json --deg --with-input "
          "--grid theta_i=5:75:6,phi_i=0:150:6,theta_o=0:80:13,phi_o=0:340:18 -o $D/data.csv && "
          "gonio fit --data $D/data.csv --deg --model ggx:schlick --anisotropic -o $D/fit.json "
          "--report $D/report.json --report $D/report.md");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("rotation 35 +-"));
  EXPECT_NEAR(at(json(content("fit.json")), "rotation").number_value(), 35, 0.05);
  EXPECT_THAT(content("report.json"), HasSubstr("\"field\": \"rotation\""));
  EXPECT_THAT(content("report.md"), HasSubstr("`rotation`"));

  const auto held =
      run("gonio fit --data $D/data.csv --deg --model ggx:schlick --rotation 35 --anisotropic -o "
          "$D/held.json");
  ASSERT_EQ(held.exit_code, 0) << held.err;
  EXPECT_EQ(at(json(content("held.json")), "rotation").number_value(), 35);

  const auto hinted =
      run("gonio fit --data $D/data.csv --deg --model ggx:schlick -q --report $D/hint.json");
  ASSERT_EQ(hinted.exit_code, 0) << hinted.err;
  EXPECT_THAT(content("hint.json"),
              HasSubstr("the data look anisotropic, with axes turned by about 35 degrees"));

  const auto wrong = run("gonio fit --data $D/data.csv --deg --model ggx --rotation 200");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, AllOf(HasSubstr("rotation is 200"), HasSubstr("[-180, 180]")));
}

}  // namespace
}  // namespace gonio::test
