// The log of goniod: one object a line as JSON, and no line that a client could forge.
#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "measured/temp_folder.h"
#include "server/support/goniod.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;
using ::testing::HasSubstr;
using ::testing::Not;

void evaluate_missing_material(const std::string& target, const std::string& name) {
  v1::EvaluateRequest request = request_for(random_pairs(1), 0, 1);
  request.mutable_material()->set_name(name);
  grpc::ClientContext context;
  v1::EvaluateResponse response;
  EXPECT_EQ(stub_for(target)->Evaluate(&context, request, &response).error_code(),
            grpc::StatusCode::NOT_FOUND);
}

TEST(Goniod, JsonLogIsOneObjectALine) {
  const TempFolder folder;
  std::ofstream(folder / "gold.json") << R"({"model": "ggx"})";
  Daemon daemon({"--listen", "127.0.0.1:0", "--lame-duck", "0", "--log-format", "json",
                 "--log-level", "debug", "--materials", (folder / "").string()});
  const std::string target = "127.0.0.1:" + std::to_string(daemon.port());
  EXPECT_TRUE(evaluate_at(target).ok());
  evaluate_missing_material(target, "\"quotes\"\nand \\ new lines");
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
  std::istringstream lines(daemon.all_output());
  int access_lines = 0;
  for (std::string line; std::getline(lines, line);) {
    google::protobuf::Struct object;
    ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(line, &object).ok()) << line;
    EXPECT_TRUE(object.fields().contains("time") && object.fields().contains("level"));
    const std::string message = object.fields().at("message").string_value();
    if (message.rfind("Evaluate from", 0) == 0) ++access_lines;
  }
  EXPECT_EQ(access_lines, 2);
}

TEST(Goniod, NothingThatAClientNamesForgesALineOfTheLog) {
  Daemon daemon({"--listen", "127.0.0.1:0", "--lame-duck", "0", "--log-level", "debug"});
  const std::string target = "127.0.0.1:" + std::to_string(daemon.port());
  evaluate_missing_material(target, "x\n2024-01-31 12:00:00.000 info forged\x1b[2J");
  v1::EvaluateRequest request = ggx_request(random_pairs(1));
  auto& fields = *request.mutable_material()->mutable_parameters()->mutable_fields();
  fields["y\r\n2024-01-31 12:00:00.000 info forged\x1b[2J"].set_number_value(1);
  grpc::ClientContext context;
  v1::EvaluateResponse response;
  EXPECT_FALSE(stub_for(target)->Evaluate(&context, request, &response).ok());
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
  std::istringstream lines(daemon.all_output());
  int quoted = 0;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_THAT(line.substr(0, 40), Not(HasSubstr("forged"))) << line;
    EXPECT_EQ(line.find_first_of("\x1b\r"), std::string::npos) << line;
    quoted += line.find("forged") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(quoted, 2);
}

}  // namespace
}  // namespace gonio::server::testing
