// The same model on the command line: every command takes it, and every table lists it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"

namespace gonio::test {
namespace {

using ::testing::HasSubstr;

class ToyCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    write_file(folder_ / "toy.json",
               R"({"model": "toy", "parameters": {"w": [0.6, 0.3, 0.1], "q": 0.2}})");
    const auto values = run(
        "evaluate -m toy.json --grid theta_i=0:1.2:12,theta_o=0:1.3:12,phi_o=0:3:8 --with-input -o "
        "data.csv");
    ASSERT_EQ(values.exit_code, 0) << values.err;
  }
  [[nodiscard]] Finished run(const std::string& arguments) const {
    return shell("cd '" + (folder_ / "").string() + "' && gonio " + arguments);
  }
  std::string out_of(const std::string& arguments) const {
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << arguments << "\n" << result.out << result.err;
    return result.out;
  }

  gonio::testing::TempFolder folder_;
};

TEST_F(ToyCommand, Models) {
  EXPECT_THAT(out_of("models"), HasSubstr("toy"));
  EXPECT_THAT(out_of("models toy"), HasSubstr("how far it falls off"));
  const auto wrong =
      run("evaluate --grid theta_i=0 -m '{\"model\": \"toy\", \"parameters\": {\"q\": 2}}'");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("0.05"));
}

TEST_F(ToyCommand, SampleAndAlbedo) {
  EXPECT_THAT(out_of("sample -m toy.json --wi 0.6,0,0.8 --count 100"), HasSubstr("pdf"));
  out_of("albedo -m toy.json --theta 30");
}

TEST_F(ToyCommand, Assess) {
  EXPECT_THAT(out_of("assess -m toy.json --pairs 500"), HasSubstr("passed"));
}

TEST_F(ToyCommand, Fit) {
  const std::string said =
      out_of("fit --data data.csv --model toy --base none -o fitted.json --report report.json");
  EXPECT_THAT(read_file(folder_ / "fitted.json"), HasSubstr("\"q\""));
  out_of("fit --data data.csv --model toy --base lambertian -o sum.json");
  out_of("compare --reference data.csv -m fitted.json");
}

TEST_F(ToyCommand, Select) {
  write_file(folder_ / "scene.json",
             R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.02, "anisotropy": false})");
  const std::string said =
      out_of("select --scene scene.json --reference data.csv --lobes 1 --all -o chosen.json");
  EXPECT_THAT(said, HasSubstr("toy"));
  EXPECT_THAT(read_file(folder_ / "chosen.json"), HasSubstr("\"toy\""));
}

TEST_F(ToyCommand, ChartAndPictures) {
  out_of("chart --parts models --quick -o chart");
  out_of("render -m toy.json --size 16x16 --spp 1 -o toy.png");
  out_of("lobe -m toy.json --theta 30 -o lobe.png");
}

}  // namespace
}  // namespace gonio::test
