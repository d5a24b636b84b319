// `gonio chart` as users see it: the files, what they hold, and errors.
#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/run_process.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

using Value = google::protobuf::Value;

std::vector<std::string> files_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) fields.emplace_back();
    if (c != '"' && (c != ',' || quoted)) fields.back() += c;
  }
  return fields;
}

// The same numbers and words in both files, column by column.
void expect_same(const google::protobuf::Struct& table, const std::string& csv) {
  const auto lines = lines_of(csv);
  const auto& columns = table.fields().at("columns").list_value();
  const auto& rows = table.fields().at("rows").list_value();
  ASSERT_EQ(lines.size(), static_cast<std::size_t>(rows.values_size()) + 1);
  const auto header = fields_of(lines[0]);
  ASSERT_EQ(header.size(), static_cast<std::size_t>(columns.values_size()));
  for (int c = 0; c < columns.values_size(); ++c) {
    const auto& column = columns.values(c).struct_value().fields();
    EXPECT_EQ(column.at("name").string_value(), header[static_cast<std::size_t>(c)]);
    EXPECT_FALSE(column.at("meaning").string_value().empty());
  }
  for (int r = 0; r < rows.values_size(); ++r) {
    const auto& row = rows.values(r).struct_value().fields();
    const auto fields = fields_of(lines[static_cast<std::size_t>(r) + 1]);
    ASSERT_EQ(fields.size(), header.size());
    for (std::size_t c = 0; c < header.size(); ++c) {
      const Value& value = row.at(header[c]);
      if (value.kind_case() == Value::kStringValue) {
        EXPECT_EQ(value.string_value(), fields[c]);
      } else if (value.kind_case() == Value::kNumberValue) {
        EXPECT_EQ(value.number_value(), std::stod(fields[c]));
      } else {
        EXPECT_EQ(fields[c], "");
      }
    }
  }
}

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
  google::protobuf::Struct chart;
  ASSERT_TRUE(
      google::protobuf::util::JsonStringToMessage(read_file(out + "/chart.json"), &chart).ok());
  const auto& machine = chart.fields().at("machine").struct_value().fields();
  EXPECT_FALSE(machine.at("processor").string_value().empty());
  EXPECT_GE(machine.at("cores").number_value(), 1);
  EXPECT_FALSE(machine.at("gonio").string_value().empty());
  EXPECT_EQ(chart.fields().at("effort").struct_value().fields().at("repetitions").number_value(),
            5);
  for (const Value& table : chart.fields().at("tables").list_value().values()) {
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
       "data is 0 usable pairs (1 left out)"},
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
