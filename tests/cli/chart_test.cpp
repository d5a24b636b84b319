// `gonio chart` as users see it: the files, what they hold, and errors.
#include <gmock/gmock.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include "cli/support/chart_files.h"
#include "cli/support/json_text.h"
#include "cli/support/run_process.h"
#include "cli/support/socket_server.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(ChartCommand, WritesTablesAndFigures) {
  const gonio::testing::TempFolder folder;
  const std::string out = folder / "new" / "chart";
  const auto result = shell("gonio chart --quick --parts approximations -o " + out);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, IsEmpty());
  EXPECT_THAT(result.out, AllOf(HasSubstr("fresnel.png"), HasSubstr("printed.csv")));
  EXPECT_THAT(files_in(out),
              ::testing::ElementsAre("chart.json", "fresnel.csv", "fresnel.gp", "fresnel.png",
                                     "fresnel.svg", "fresnel_angles.csv", "fresnel_angles.gp",
                                     "fresnel_angles.png", "fresnel_angles.svg", "printed.csv",
                                     "printed.gp", "printed.png", "printed.svg"));
  const auto chart = json(read_file(out + "/chart.json"));
  const auto& machine = chart.fields().at("machine").struct_value().fields();
  EXPECT_FALSE(machine.at("processor").string_value().empty());
  EXPECT_GE(machine.at("cores").number_value(), 1);
  EXPECT_FALSE(machine.at("gonio").string_value().empty());
  EXPECT_EQ(chart.fields().at("effort").struct_value().fields().at("repetitions").number_value(),
            5);
  for (const auto& table : chart.fields().at("tables").list_value().values()) {
    const std::string name = table.struct_value().fields().at("name").string_value();
    expect_same(table.struct_value(), read_file(out + "/" + name + ".csv"));
    EXPECT_THAT(read_file(out + "/" + name + ".png"), StartsWith("\x89PNG"));
    EXPECT_THAT(read_file(out + "/" + name + ".svg"), HasSubstr("<svg"));
  }
}

TEST(ChartCommand, MeasuresTheWireOfAServerOfItsOwn) {
  const gonio::testing::TempFolder folder;
  const std::string out = folder / "chart";
  const auto result = shell("gonio chart --quick --quiet --parts wire -o " + out);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, IsEmpty());
  const auto lines = lines_of(read_file(out + "/wire.csv"));
  EXPECT_THAT(lines.front(), StartsWith("form,call,pairs,chunk,us,"));
  EXPECT_THAT(lines, ::testing::Contains(StartsWith("grid,stream,1048576,65536,")));
}

// A server's measurements on this machine differ from the tool's own in nothing but times, of its
// own cases and of pairs that are sent to it.
TEST(ChartCommand, AServersChartIsTheSameButForTimes) {
  const gonio::testing::TempFolder folder;
  const SocketServer server;
  std::string rows = "theta_i,phi_i,theta_o,phi_o,f_0\n";
  for (int i = 0; i < 300; ++i)
    rows += std::to_string(i % 7 * 0.2) + ",0," + std::to_string(i % 11 * 0.1) + "," +
            std::to_string(i % 13 * 0.4) + "," + std::to_string(0.1 + i % 7 * 0.01) + "\n";
  write_file(folder / "pairs.csv", rows);
  const auto chart = [&](const std::string& name, const std::string& where) {
    const auto result = shell("cd '" + (folder / "").string() +
                              "' && gonio chart --quick --quiet --parts fits,approximations "
                              "--data pairs.csv -o " +
                              name + where);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json(read_file(folder / (name + "/chart.json"))).fields();
  };
  const auto own = chart("own", ""), other = chart("other", " --server " + server.address());
  EXPECT_TRUE(
      google::protobuf::util::MessageDifferencer::Equals(own.at("machine"), other.at("machine")));
  EXPECT_EQ(files_in(folder / "own"), files_in(folder / "other"));
  for (const char* table : {"fits", "fresnel", "fresnel_angles", "printed"}) {
    const auto csv = [&](const std::string& of) {
      return what_is_not_timed(read_file(folder / (of + "/" + table + ".csv")));
    };
    EXPECT_EQ(csv("own"), csv("other")) << table;
  }
}

TEST(ChartCommand, AServerThatIsNotThereExitsWithThree) {
  const gonio::testing::TempFolder folder;
  const std::string out = folder / "chart";
  const auto result = shell("gonio chart --quick --server 127.0.0.1:1 -o " + out);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("127.0.0.1:1"));
  EXPECT_THAT(files_in(out), IsEmpty());
}

// What is already there stays, and tables without figures are still tables.
TEST(ChartCommand, SaysThatGnuplotIsMissing) {
  const gonio::testing::TempFolder folder;
  const std::string out = folder / "chart";
  const auto result = shell("PATH=/nowhere gonio chart --quick --parts approximations -o " + out);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, AllOf(HasSubstr("gnuplot is not installed"), HasSubstr(out)));
  EXPECT_THAT(files_in(out), ::testing::ElementsAre("chart.json", "fresnel.csv", "fresnel.gp",
                                                    "fresnel_angles.csv", "fresnel_angles.gp",
                                                    "printed.csv", "printed.gp"));
}

TEST(ChartCommand, BadInputIsRefusedBeforeTheWork) {
  const gonio::testing::TempFolder folder;
  write_file(folder / "file", "");
  write_file(folder / "bad.binary", "not a table");
  write_file(folder / "pairs.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0.1,0,0.2,0,1\n");
  write_file(folder / "nan.csv", "theta_i,phi_i,theta_o,phi_o,f_0\n0.1,0,0.2,0,nan\n");
  const std::string out = folder / "chart", file = folder / "file", bad = folder / "bad.binary",
                    pairs = folder / "pairs.csv";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "--output is required"},
      {"-o -", "--output is -; allowed: a folder"},
      {"-o " + file, file + " cannot be made"},
      {"-o " + file + "/below", "cannot be made: Not a directory"},
      {"-o " + out + " --parts models,nothing", "nothing"},
      {"-o " + out + " --data " + bad, bad},
      {"-o " + out + " --data /nowhere.binary", "/nowhere.binary"},
      {"-o " + out + " --quick --parts fits --data " + (folder / "nan.csv").string(),
       "without a usable pair, 1 left out (1 not finite)"},
      {"-o " + out + " --parts resolution --data " + pairs, "resolution, of scattered pairs"}};
  for (const auto& [arguments, words] : cases) {
    const auto result = shell("gonio chart " + arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_THAT(result.err, HasSubstr(words)) << arguments;
    EXPECT_THAT(result.out, IsEmpty());
  }
  EXPECT_THAT(files_in(out), IsEmpty());
}

TEST(ChartCommand, GivesUpByItsDeadline) {
  const gonio::testing::TempFolder folder;
  const std::string out = folder / "chart";
  const auto result = shell("gonio chart --parts models --deadline 0.2 -o " + out);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("not done within --deadline 0.2"));
  EXPECT_THAT(files_in(out), IsEmpty());
}

TEST(ChartCommand, IsInTheHelp) {
  EXPECT_THAT(shell("gonio chart --help").out,
              AllOf(HasSubstr("resolution"), HasSubstr("--quick"), HasSubstr("--data")));
}

}  // namespace
}  // namespace gonio::test
