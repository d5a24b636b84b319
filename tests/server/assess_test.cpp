// Assess: the core's own report over the wire, what is refused, what is cancelled.
#include "assess/assess.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "effort.h"
#include "server/messages/assess_request.h"
#include "server/support/harness.h"
#include "wire/convert.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::kSlower;
using gonio::testing::WorkClock;
using namespace std::chrono_literals;
using ::testing::HasSubstr;
using Clock = WorkClock;  // a million pairs a place are half a minute's work

v1::AssessRequest ggx_assessment(std::uint32_t pairs = 500) {
  v1::AssessRequest request;
  set_ggx(*request.mutable_material());
  request.set_pairs(pairs);
  return request;
}

grpc::Status assess(TestServer& server, const v1::AssessRequest& request,
                    v1::AssessResponse* response) {
  grpc::ClientContext context;
  return server.stub->Assess(&context, request, response);
}

Error refused(TestServer& server, const v1::AssessRequest& request) {
  v1::AssessResponse response;
  const grpc::Status status = assess(server, request, &response);
  EXPECT_FALSE(status.ok());
  return wire::from_status(status);
}

TEST(AssessCall, IsTheCoresOwnReport) {
  TestServer server;
  v1::AssessResponse response;
  v1::AssessRequest request = ggx_assessment();
  request.mutable_limits()->set_loss(0.2);
  request.set_seed(7);
  const grpc::Status status = assess(server, request, &response);
  ASSERT_TRUE(status.ok()) << status.error_message();
  assess::Options options;
  options.pairs = 500;
  options.seed = 7;
  options.limits.loss = 0.2;
  const auto own = assess::assess(Sampler::create(core_ggx()), options, best_isa());
  ASSERT_TRUE(own.ok());
  v1::AssessResponse expected = to_wire(*own);
  expected.set_instruction_set(wire::to_wire(best_isa()));
  expected.clear_cpu_seconds();
  EXPECT_GT(response.cpu_seconds(), 0);
  response.clear_cpu_seconds();
  EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(response, expected));
  EXPECT_FALSE(response.passed());  // f0 of .29 loses more than .2
}

TEST(AssessCall, SaysWhatIsWrong) {
  TestServer server;
  v1::AssessRequest request = ggx_assessment();
  request.mutable_limits()->set_gain(-1);
  EXPECT_EQ(refused(server, request).field, "limits.gain");
  EXPECT_EQ(refused(server, ggx_assessment(2'000'000)).field, "pairs");
  request = ggx_assessment();
  request.mutable_material()->set_model("nothing");
  EXPECT_EQ(refused(server, request).field, "material.model");
  request = ggx_assessment();
  request.clear_material();
  EXPECT_EQ(refused(server, request).field, "material");
  request = ggx_assessment();
  request.set_instruction_set(static_cast<v1::InstructionSet>(77));
  EXPECT_EQ(refused(server, request).field, "instruction_set");
  request = ggx_assessment();
  auto& fields = *request.mutable_material()->mutable_parameters()->mutable_fields();
  for (int i = 0; i < 100'000; ++i)
    fields["f0"].mutable_list_value()->add_values()->set_number_value(0.5);
  EXPECT_EQ(refused(server, request).field, "material");  // refused before it is parsed
}

TEST(AssessCall, EndsSoonWhenItIsCancelled) {
  ServerOptions options;
  options.fit_threads = 1;
  TestServer server(options);
  grpc::ClientContext context;
  v1::AssessResponse response;
  std::thread cancel([&] {
    std::this_thread::sleep_for(100ms);
    context.TryCancel();
  });
  const grpc::Status status = server.stub->Assess(&context, ggx_assessment(1'000'000), &response);
  cancel.join();
  EXPECT_EQ(status.error_code(), grpc::StatusCode::CANCELLED);
  // The only thread is soon free for the next.
  const auto begin = Clock::now();
  EXPECT_TRUE(assess(server, ggx_assessment(10), &response).ok());
  EXPECT_LT(Clock::now() - begin, kSlower * 2s);
}

TEST(AssessCall, KeepsTheServersOwnDeadline) {
  ServerOptions options;
  options.longest_fit = 100ms;
  TestServer server(options);
  v1::AssessResponse response;
  const auto begin = Clock::now();
  const grpc::Status status = assess(server, ggx_assessment(1'000'000), &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  EXPECT_THAT(status.error_message(), HasSubstr("the assessment was not done"));
  EXPECT_LT(Clock::now() - begin, kSlower * 2s);
}

TEST(AssessCall, WaitsInAQueueThatIsBounded) {
  ServerOptions options;
  options.fit_threads = 1;
  options.max_fits = 1;
  TestServer server(options);
  grpc::ClientContext context;
  grpc::Status of_the_long;
  std::atomic<bool> is_over = false;
  std::thread first([&] {
    v1::AssessResponse response;
    of_the_long = server.stub->Assess(&context, ggx_assessment(1'000'000), &response);
    is_over = true;
  });
  // Short ones beside it: they are refused, or it is where it comes while one of them runs.
  Error error;
  for (int i = 0; i < 200 && !is_over && error.code != ErrorCode::resource_exhausted; ++i) {
    v1::AssessResponse response;
    const grpc::Status status = assess(server, ggx_assessment(1), &response);
    if (!status.ok()) error = wire::from_status(status);
  }
  context.TryCancel();
  first.join();
  if (error.code != ErrorCode::resource_exhausted) error = wire::from_status(of_the_long);
  EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
  EXPECT_THAT(error.message,
              HasSubstr("queue of fits, assessments, selections and charts is full"));
}

// It runs where no evaluation waits for it: while one that would take long is under way, batches
// are computed one after the other.
TEST(AssessCall, LeavesEvaluationAlone) {
  ServerOptions options;
  options.threads = 1;
  options.fit_threads = 1;
  TestServer server(options);
  grpc::ClientContext context;
  std::thread assessing([&] {
    v1::AssessResponse response;
    server.stub->Assess(&context, ggx_assessment(1'000'000), &response);
  });
  const auto request = ggx_request(random_pairs(20'000));
  std::this_thread::sleep_for(50ms);
  for (int i = 0; i < 20; ++i) server.evaluated(request);
  context.TryCancel();
  assessing.join();
}

}  // namespace
}  // namespace gonio::server::testing
