// A server whose clients want more memory than it may use goes on: it ends streams, not itself.
// --gtest_repeat=20 makes the trial longer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "effort.h"
#include "server/support/daemon.h"
#include "server/support/flood.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::kSlower;
using ::testing::HasSubstr;

constexpr auto kTime = std::chrono::seconds(kSlower == 1 ? 4 : 8);

class Pressure : public ::testing::TestWithParam<int> {};

// 100 streams of requests of 1.5 MB are more than either quota, by far.
TEST_P(Pressure, OfReadersAndOfClientsThatNeverReadEndsNoServer) {
  Daemon daemon({"--listen", "127.0.0.1:0", "--memory-quota-mb", std::to_string(GetParam()),
                 "--lame-duck", "0", "--grace", "0"});
  const std::string target = "127.0.0.1:" + std::to_string(daemon.port());
  Flood::Result result;
  {
    Flood flood(target, 50, 50);
    result = flood.run(kTime);
  }
  RecordProperty("answers", result.answers);
  RecordProperty("broken", result.broken);
  EXPECT_GT(result.answers, 0);
  const auto stub =
      v1::GonioService::NewStub(grpc::CreateChannel(target, grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  v1::EvaluateResponse response;
  const grpc::Status status = stub->Evaluate(&context, ggx_request(random_pairs(5)), &response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
  EXPECT_THAT(daemon.all_output(), HasSubstr("stopped"));
}

INSTANTIATE_TEST_SUITE_P(Quotas, Pressure, ::testing::Values(64, 128));

}  // namespace
}  // namespace gonio::server::testing
