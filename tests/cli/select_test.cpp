// `gonio select` as users and pipelines see it: tables, files, the exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/json_text.h"
#include "cli/support/select_fixture.h"
#include "cli/support/socket_server.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(SelectCommand, PrintsTheFrontAndWritesTheChoice) {
  const auto result =
      select("--reference gloss.json --scene scene.json --all -o out.json --report r.json");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("candidate"), HasSubstr("\n* "), HasSubstr("searched"),
                    HasSubstr("chosen; certified "), HasSubstr("has a certified error of"),
                    HasSubstr("Searched: the error"), HasSubstr("the tolerance\nis 0.6."),
                    HasSubstr("no better than"), HasSubstr("oren_nayar:full")));
  EXPECT_TRUE(json(read_file(folder_ / "out.json")).fields().contains("model"));
  const auto report = json(read_file(folder_ / "r.json"));
  EXPECT_EQ(report.fields().at("choice").struct_value().fields().at("confidence").number_value(),
            0.975);
  EXPECT_GE(report.fields().at("entries").list_value().values_size(), 20);
}

// What is chosen depends on seed and reference, not on where the work is done.
TEST_F(SelectCommand, AServersChoiceIsTheSame) {
  const SocketServer server{{{"stored", kGloss}}};
  write("close.json",
        R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.05, "anisotropy": false})");
  const std::string common = "--no-front --scene close.json ";
  const auto embedded = select(common + "--reference gloss.json -o a.json --report a-report.json");
  ASSERT_EQ(embedded.exit_code, 0) << embedded.err;
  EXPECT_TRUE(json(read_file(folder_ / "a.json")).fields().contains("specular"));
  for (const char* reference : {"gloss.json", "stored"}) {
    const auto remote = select(common + "-o b.json --report b-report.json --reference " +
                               reference + " --server " + server.address());
    EXPECT_EQ(remote.exit_code, 0) << remote.err;
    EXPECT_EQ(remote.out, embedded.out);
    for (const char* file : {".json", "-report.json"})
      EXPECT_EQ(read_file(folder_ / ("b" + std::string(file))),
                read_file(folder_ / ("a" + std::string(file))));
  }
}

TEST_F(SelectCommand, AServerThatIsNotThereExitsWithThree) {
  const auto result =
      select("--reference grey.json --scene scene.json -o out.json --server 127.0.0.1:1");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(result.err, HasSubstr("127.0.0.1:1"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.json"));
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
  for (int i = 0; i < 600; ++i)
    rows += std::to_string(i % 7 * 0.1) + ",0," + std::to_string(i % 11 * 0.1) + "," +
            std::to_string(i % 13 * 0.4) + "," + std::to_string(i % 5) + "\n";
  write("noise.csv", rows);
  const SocketServer server;
  for (const std::string& where : {std::string(), " --server " + server.address()}) {
    const auto result = select("--reference noise.csv --scene scene.json -o out.json" + where);
    EXPECT_EQ(result.exit_code, 4) << result.err;
    EXPECT_THAT(result.out, HasSubstr("no candidate meets the tolerance of 0.6"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.json"));
  }
}

}  // namespace
}  // namespace gonio::test
