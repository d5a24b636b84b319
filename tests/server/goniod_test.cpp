// goniod as its users run it: a process with arguments, signals, a log and an exit code.
#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "measured/temp_folder.h"
#include "server/daemon.h"
#include "server/harness.h"

namespace gonio::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::unique_ptr<v1::GonioService::Stub> stub_for(const std::string& target) {
  return v1::GonioService::NewStub(grpc::CreateChannel(target, grpc::InsecureChannelCredentials()));
}

grpc::Status evaluate_at(const std::string& target) {
  grpc::ClientContext context;
  v1::EvaluateResponse response;
  return stub_for(target)->Evaluate(&context, ggx_request(random_pairs(5000)), &response);
}

void evaluate_missing_material(const std::string& target, const std::string& name) {
  v1::EvaluateRequest request = request_for(random_pairs(1), 0, 1);
  request.mutable_material()->set_name(name);
  grpc::ClientContext context;
  v1::EvaluateResponse response;
  EXPECT_EQ(stub_for(target)->Evaluate(&context, request, &response).error_code(),
            grpc::StatusCode::NOT_FOUND);
}

// Of a process that ends by itself.
std::pair<int, std::string> run(const std::vector<std::string>& arguments) {
  Daemon daemon(arguments);
  const std::string output = daemon.all_output();
  return {daemon.wait_for_exit(), output};
}

TEST(Goniod, ServesTcpAndUnixAndStopsCleanlyOnSigterm) {
  const TempFolder folder;
  const std::string socket = (folder / "s").string();
  Daemon daemon({"--listen", "127.0.0.1:0", "--listen", "unix:" + socket, "--lame-duck", "0.1"});
  const int port = daemon.port();
  ASSERT_GT(port, 0);
  ASSERT_NE(daemon.line_with("stored materials"), "");
  EXPECT_TRUE(evaluate_at("127.0.0.1:" + std::to_string(port)).ok());
  EXPECT_TRUE(evaluate_at("unix:" + socket).ok());
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
  EXPECT_THAT(daemon.all_output(), HasSubstr("stopped"));
  EXPECT_FALSE(std::filesystem::exists(socket));
}

TEST(Goniod, StopsWithinItsGraceThoughAStreamIsOpen) {
  Daemon daemon({"--listen", "127.0.0.1:0", "--lame-duck", "0", "--grace", "0.2"});
  const auto stub = stub_for("127.0.0.1:" + std::to_string(daemon.port()));
  grpc::ClientContext context;
  const auto call = stub->EvaluateStream(&context);
  v1::EvaluateStreamRequest chunk;
  *chunk.mutable_evaluate() = ggx_request(random_pairs(1));
  ASSERT_TRUE(call->Write(chunk));
  v1::EvaluateStreamResponse answer;
  ASSERT_TRUE(call->Read(&answer));
  daemon.send(SIGINT);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
  EXPECT_FALSE(call->Read(&answer));
  EXPECT_FALSE(call->Finish().ok());
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

TEST(Goniod, APortInUseIsAClearErrorAndANonZeroExit) {
  Daemon first({"--listen", "127.0.0.1:0"});
  const std::string taken = "127.0.0.1:" + std::to_string(first.port());
  const auto [code, output] = run({"--listen", taken});
  EXPECT_EQ(code, 1);
  EXPECT_THAT(output, AllOf(HasSubstr(taken), HasSubstr("in use")));
  EXPECT_TRUE(evaluate_at(taken).ok());
}

TEST(Goniod, BadArgumentsAreClearErrors) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"--no-such-option"}, "--no-such-option"},
      {{"--materal", "x"}, "mean \"--materials\"?"},
      {{"--log-level", "warn"}, "mean \"warning\"?"},
      {{"--threads", "many"}, "--threads"},
      {{"--max-message-mb", "0"}, "--max-message-mb"},
      {{"--log-format", "xml"}, "--log-format"},
      {{"--log-level", "loud"}, "--log-level"},
      {{"--threads", "-3"}, "--threads"},
      {{"--max-queue", "0"}, "--max-queue"},
      {{"--memory-quota-mb", "8"}, "--memory-quota-mb"},
  };
  for (const auto& [arguments, what] : cases) {
    const auto [code, output] = run(arguments);
    EXPECT_EQ(code, 2);
    EXPECT_THAT(output, HasSubstr(what));
  }
}

TEST(Goniod, WhatCannotBeServedIsAClearError) {
  const TempFolder folder;
  std::ofstream(folder / "bad.json") << "{";
  const std::pair<std::vector<std::string>, std::string> cases[] = {
      {{"--listen", "nonsense"}, "nonsense"},
      {{"--listen", "127.0.0.1:0", "--materials", "/no/such"}, "/no/such"},
      {{"--listen", "127.0.0.1:0", "--materials", (folder / "").string()}, "bad.json"},
      {{"--listen", "nonsense", "--log-level", "off"}, "nonsense"},
  };
  for (const auto& [arguments, what] : cases) {
    const auto [code, output] = run(arguments);
    EXPECT_EQ(code, 2);
    EXPECT_THAT(output, HasSubstr(what));
  }
}

TEST(Goniod, VersionAndHelp) {
  EXPECT_THAT(run({"--version"}), ::testing::Pair(0, HasSubstr("goniod 0.")));
  EXPECT_THAT(run({"--help"}),
              ::testing::Pair(0, AllOf(HasSubstr("--listen"), HasSubstr("--materials"))));
}

TEST(Goniod, AKilledServerLeavesASocketThatTheNextOneReplaces) {
  const TempFolder folder;
  const std::string address = "unix:" + (folder / "s").string();
  {
    Daemon first({"--listen", address});
    ASSERT_NE(first.line_with("stored materials"), "");
    first.send(SIGKILL);
    EXPECT_EQ(first.wait_for_exit(), -SIGKILL);
  }
  Daemon second({"--listen", address});
  ASSERT_NE(second.line_with("stored materials"), "");
  EXPECT_TRUE(evaluate_at(address).ok());
}

}  // namespace
}  // namespace gonio::testing
