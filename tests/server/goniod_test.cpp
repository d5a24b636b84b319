// goniod as its users run it: a process with arguments, signals, a log and an exit code.
#include <gmock/gmock.h>
#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>
#include <tuple>

#include "gonio/measured/table.h"
#include "measured/synthetic_merl.h"
#include "measured/temp_folder.h"
#include "server/support/daemon.h"
#include "server/support/harness.h"
#include "wire/sha256.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::glossy_example;
using gonio::testing::TempFolder;
using gonio::testing::write_merl;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

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
      {{"--grace", "nan"}, "--grace"},
      {{"--lame-duck", "nan"}, "--lame-duck"},
      {{"--longest-fit", "nan"}, "--longest-fit"},
      {{"--longest-fit", "0"}, "--longest-fit"},
      {{"--max-queue", "99999999999999999999"}, "--max-queue"},
      {{"--fit-threads", "0"}, "--fit-threads"},
      {{"--max-fits", "-1"}, "--max-fits"},
      {{"--put-quota-mb", "x"}, "--put-quota-mb"},
      {{"--listen", "unix:s", "--socket-mode", "rw"}, "--socket-mode"},
      {{"--listen", "unix:s", "--socket-mode", "0888"}, "--socket-mode"},
      {{"--listen", "unix:s", "--socket-mode", "0060"}, "0600 to 0777"},
      {{"--socket-mode", "0660"}, "--socket-mode"},
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
  const std::tuple<std::vector<std::string>, int, std::string> cases[] = {
      {{"--listen", "nonsense"}, 2, "nonsense"},
      {{"--listen", "unix://x"}, 2, "unix://x"},
      {{"--listen", "unix:/" + std::string(200, 'x')}, 2, "at most 107 bytes"},
      {{"--listen", "nonsense", "--log-level", "off"}, 2, "nonsense"},
      {{"--listen", "127.0.0.1:0", "--materials", "/no/such"}, 2, "/no/such"},
      {{"--listen", "127.0.0.1:0", "--check", "--materials", (folder / "").string()},
       2,
       "bad.json"},
  };
  for (const auto& [arguments, expected, what] : cases) {
    const auto [code, output] = run(arguments);
    EXPECT_EQ(code, expected) << what;
    EXPECT_THAT(output, HasSubstr(what));
  }
}

TEST(Goniod, CheckServesNothing) {
  const TempFolder folder;
  std::ofstream(folder / "gold.json") << R"({"model": "ggx"})";
  Daemon living({"--listen", "127.0.0.1:0"});
  const std::string taken = "127.0.0.1:" + std::to_string(living.port());
  const auto [code, output] =
      run({"--check", "--listen", taken, "--materials", (folder / "").string()});
  EXPECT_EQ(code, 0) << output;
  EXPECT_THAT(output, HasSubstr("stored materials: 1, not served: 0"));
}

TEST(Goniod, ABadFileIsSkippedAndSaidSo) {
  const TempFolder folder;
  std::ofstream(folder / "gold.json") << R"({"model": "ggx"})";
  std::ofstream(folder / "rough.json") << R"({"model": "ggx", "parameters": {"alpha_x": 7}})";
  std::ofstream(folder / "cut.binary") << "12";
  Daemon daemon(
      {"--listen", "127.0.0.1:0", "--lame-duck", "0", "--materials", (folder / "").string()});
  EXPECT_THAT(daemon.line_with("not served: cut.binary"), HasSubstr(" warning "));
  EXPECT_THAT(daemon.line_with("not served: rough.json"), HasSubstr("alpha_x"));
  EXPECT_THAT(daemon.line_with("stored materials: 1"), HasSubstr("not served: 2"));
}

double seconds_to_end(Daemon& daemon, int signal) {
  const auto start = std::chrono::steady_clock::now();
  daemon.send(signal);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

constexpr double kAtOnce = 5;  // of a grace of 60 s, on a busy machine

TEST(Goniod, GraceIsForCallsAndNotForConnections) {
  Daemon daemon({"--listen", "127.0.0.1:0", "--lame-duck", "0", "--grace", "60"});
  const int port = daemon.port();
  // Of a client that says nothing, one that has asked, and a stream that owes nothing.
  const int silent = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_port = htons(static_cast<std::uint16_t>(port));
  where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(connect(silent, reinterpret_cast<const sockaddr*>(&where), sizeof where), 0);
  const auto stub = stub_for("127.0.0.1:" + std::to_string(port));
  grpc::ClientContext context;
  const auto call = stub->EvaluateStream(&context);
  v1::EvaluateStreamRequest chunk;
  *chunk.mutable_evaluate() = ggx_request(random_pairs(1));
  ASSERT_TRUE(call->Write(chunk));
  v1::EvaluateStreamResponse answer;
  ASSERT_TRUE(call->Read(&answer));
  EXPECT_LT(seconds_to_end(daemon, SIGTERM), kAtOnce);
  EXPECT_FALSE(call->Read(&answer));
  EXPECT_FALSE(call->Finish().ok());
  close(silent);
}

// An upload that has not come to its end.
struct SlowPut {
  explicit SlowPut(int port) : stub(stub_for("127.0.0.1:" + std::to_string(port))) {
    call = stub->PutMaterial(&context, &response);
    v1::PutMaterialRequest part;
    part.mutable_file()->set_name("grey");
    part.mutable_file()->set_size(12 + 3 * sizeof(double) * MeasuredTable::kCells);
    part.mutable_file()->set_sha256(std::string(32, 'x'));
    EXPECT_TRUE(call->Write(part));
  }
  std::unique_ptr<v1::GonioService::Stub> stub;
  grpc::ClientContext context;
  v1::PutMaterialResponse response;
  std::unique_ptr<grpc::ClientWriter<v1::PutMaterialRequest>> call;
};

TEST(Goniod, ACallUnderWayHasTheGraceAndASecondSignalEndsThat) {
  Daemon daemon({"--listen", "127.0.0.1:0", "--lame-duck", "0", "--grace", "60"});
  SlowPut put(daemon.port());
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  daemon.send(SIGINT);
  ASSERT_NE(daemon.line_with("stopping"), "");
  std::this_thread::sleep_for(std::chrono::milliseconds(1000));
  EXPECT_EQ(waitpid(daemon.pid(), nullptr, WNOHANG), 0);  // the grace is for this call
  EXPECT_LT(seconds_to_end(daemon, SIGINT), kAtOnce);
  EXPECT_THAT(daemon.all_output(), AllOf(HasSubstr("asked to stop again"), HasSubstr("stopped")));
  EXPECT_FALSE(put.call->Finish().ok());
}

TEST(Goniod, ACallUnderWayIsAnsweredWithinTheGrace) {
  Daemon daemon({"--listen", "127.0.0.1:0", "--lame-duck", "0", "--grace", "60"});
  SlowPut put(daemon.port());
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  daemon.send(SIGTERM);
  ASSERT_NE(daemon.line_with("stopping"), "");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_TRUE(put.call->WritesDone());
  EXPECT_EQ(put.call->Finish().error_code(), grpc::StatusCode::DATA_LOSS);  // too short: its answer
  EXPECT_EQ(daemon.wait_for_exit(), 0);
}

TEST(Goniod, SighupEndsNothing) {
  Daemon daemon({"--listen", "127.0.0.1:0", "--lame-duck", "0"});
  const std::string target = "127.0.0.1:" + std::to_string(daemon.port());
  daemon.send(SIGHUP);
  EXPECT_THAT(daemon.line_with("SIGHUP"), HasSubstr("ignored"));
  EXPECT_TRUE(evaluate_at(target).ok());
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
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

TEST(Goniod, WhatAKilledServerHalfStoredGoesWithTheNextStart) {
  const TempFolder folder, other;
  ASSERT_TRUE(write_merl(other / "x.binary", glossy_example));
  std::ifstream in(other / "x.binary", std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  const auto leftovers = [&] {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
      count += entry.path().filename().string().rfind(".put-", 0) == 0 ? 1U : 0U;
    return count;
  };
  {
    Daemon first({"--listen", "127.0.0.1:0", "--materials", (folder / "").string()});
    const auto stub = stub_for("127.0.0.1:" + std::to_string(first.port()));
    std::thread watcher([&] {
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
      while (leftovers() == 0 && std::chrono::steady_clock::now() < end) {
      }
      first.send(SIGKILL);
    });
    grpc::ClientContext context;
    v1::PutMaterialResponse response;
    const auto call = stub->PutMaterial(&context, &response);
    v1::PutMaterialRequest part;
    part.mutable_file()->set_name("grey");
    part.mutable_file()->set_size(content.size());
    const auto sum = wire::sha256(content);
    part.mutable_file()->set_sha256(std::string(sum.begin(), sum.end()));
    call->Write(part);
    for (std::size_t at = 0; at < content.size(); at += 1 << 20) {
      part.set_chunk(content.substr(at, 1 << 20));
      if (!call->Write(part)) break;
    }
    call->WritesDone();
    EXPECT_FALSE(call->Finish().ok());
    watcher.join();
    EXPECT_EQ(first.wait_for_exit(), -SIGKILL);
  }
  ASSERT_EQ(leftovers(), 1U);
  Daemon second({"--listen", "127.0.0.1:0", "--materials", (folder / "").string()});
  EXPECT_NE(second.line_with("removed 1 unfinished"), "");
  EXPECT_GT(second.port(), 0);
  EXPECT_EQ(leftovers(), 0U);
}

TEST(Goniod, ASocketHasItsMode) {
  const TempFolder folder;
  const std::string path = (folder / "s#1").string();
  Daemon daemon({"--listen", "unix:" + path, "--socket-mode", "0660", "--lame-duck", "0"});
  ASSERT_NE(daemon.line_with("stored materials"), "");
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0660));
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
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
}  // namespace gonio::server::testing
