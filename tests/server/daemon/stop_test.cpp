// How goniod ends: signals, the grace for calls under way, and what nobody waits for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "gonio/measured/table.h"
#include "measured/temp_folder.h"
#include "server/support/goniod.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

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

}  // namespace
}  // namespace gonio::server::testing
