// Work that nobody waits for any more is not done: looked at when a job leaves the queue and before
// each tile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "server/support/busy_pool.h"
#include "server/support/stream_client.h"
#include "server/work/background_queue.h"
#include "server/work/evaluation.h"
#include "wire/codec.h"

namespace gonio::server::testing {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using Clock = std::chrono::system_clock;

std::shared_ptr<Evaluation> evaluation_of(std::size_t pairs) {
  const std::string bytes = ggx_request(random_pairs(pairs)).SerializeAsString();
  const grpc::Slice slice(bytes);
  const auto request = wire::decode<wire::Request>(grpc::ByteBuffer(&slice, 1));
  auto evaluation = Evaluation::prepare(*request, core_ggx(), std::size_t{64} << 20);
  EXPECT_TRUE(evaluation.ok());
  return *evaluation;
}

struct Computing {
  explicit Computing(int threads = 1) : pool(threads, 8) {}
  // Runs the batch; whether it was completed.
  std::future<bool> start(const std::shared_ptr<Evaluation>& evaluation, const CallState& state) {
    auto done = std::make_shared<std::promise<bool>>();
    static MemoryBudget memory(1 << 30);  // outlives the evaluations of all tests
    const Backend backend{
        materials, pool, 1 << 20, 8, logger, memory, FitBackend{fits, std::chrono::seconds(1)},
        puts,      calls};
    EXPECT_TRUE(compute(backend, evaluation, state, [done](bool completed) {
                  done->set_value(completed);
                }).ok());
    return done->get_future();
  }
  Materials materials;
  BackgroundQueue fits{1, 1}, puts{1, 1};
  CallsUnderWay calls;
  spdlog::logger logger{"test"};
  ThreadPool pool;
};

TEST(Cancel, ACallOverInTheQueueIsNotComputedAtAll) {
  Computing computing;
  std::promise<void> free;
  ASSERT_TRUE(computing.pool.submit({1, [&](std::size_t) { free.get_future().wait(); }, {}, {}}));
  CallState state(Clock::time_point::max());
  const auto evaluation = evaluation_of(20'000);
  auto completed = computing.start(evaluation, state);
  state.cancel();
  free.set_value();
  EXPECT_FALSE(completed.get());
  EXPECT_EQ(evaluation->kernel_seconds(), 0);
}

TEST(Cancel, ACallOverInTheMiddleStopsAtTheNextTile) {
  Computing computing;
  CallState state(Clock::time_point::max());
  const auto evaluation = evaluation_of(100 * kTilePairs);
  // The pool takes tiles of its jobs in turn, so the batch has run a tile or two when this cancels
  // it.
  std::promise<void> go;
  ASSERT_TRUE(computing.pool.submit({1, [&](std::size_t) { go.get_future().wait(); }, {}, {}}));
  auto completed = computing.start(evaluation, state);
  ASSERT_TRUE(computing.pool.submit({1, [&](std::size_t) { state.cancel(); }, {}, {}}));
  go.set_value();
  EXPECT_FALSE(completed.get());
  EXPECT_GT(evaluation->kernel_seconds(), 0);
}

TEST(Cancel, ADeadlineThatPassesInTheQueueIsSeen) {
  Computing computing;
  const CallState late(Clock::now() - 1ms);
  const auto evaluation = evaluation_of(20'000);
  EXPECT_FALSE(computing.start(evaluation, late).get());
  EXPECT_EQ(evaluation->kernel_seconds(), 0);
}

TEST(Cancel, DeadlineOfACallThatWaits) {
  BusyService service(4);
  grpc::ClientContext context;
  context.set_deadline(Clock::now() + 50ms);
  v1::EvaluateResponse response;
  const auto status = service.stub->Evaluate(&context, ggx_request(random_pairs(5000)), &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  service.free();
  service.stop_server();
  EXPECT_THAT(service.log(), HasSubstr("the call was over before its batch was computed"));
  EXPECT_THAT(service.log(), HasSubstr("kernels 0.000 ms"));
}

TEST(Cancel, AStreamThatIsCancelledFreesTheServer) {
  BusyService service(16);
  const PairArrays pairs = random_pairs(5000);
  grpc::ClientContext context;
  const auto call = service.stub->EvaluateStream(&context);
  for (auto& chunk : chunked(pairs, 1000)) EXPECT_TRUE(call->Write(chunk));
  v1::EvaluateStreamRequest large;
  large.set_sequence(99);
  *large.mutable_evaluate() = ggx_request(pairs);
  EXPECT_TRUE(call->Write(large));
  while (service.pool().jobs() < 2) std::this_thread::yield();
  context.TryCancel();
  for (v1::EvaluateStreamResponse answer; call->Read(&answer);) EXPECT_NE(answer.sequence(), 99U);
  EXPECT_EQ(call->Finish().error_code(), grpc::StatusCode::CANCELLED);
  service.free();
  while (service.pool().jobs() > 0) std::this_thread::yield();
  service.stop_server();  // hangs if the stream's reactor does not end
}

TEST(Cancel, AStreamPastItsDeadlineDoesNotEndAsIfComplete) {
  BusyService service(16);
  grpc::ClientContext context;
  context.set_deadline(Clock::now() + 50ms);
  const auto call = service.stub->EvaluateStream(&context);
  for (auto& chunk : chunked(random_pairs(5000), 5000)) EXPECT_TRUE(call->Write(chunk));
  call->WritesDone();
  v1::EvaluateStreamResponse answer;
  EXPECT_FALSE(call->Read(&answer));
  EXPECT_EQ(call->Finish().error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
}

TEST(Cancel, ManyAbandonedStreamsLeaveNothingBehind) {
  TestServer server;
  const auto chunks = chunked(random_pairs(60'000), 20'000);
  for (int i = 0; i < 20; ++i) {
    grpc::ClientContext context;
    const auto call = server.stub->EvaluateStream(&context);
    for (const auto& chunk : chunks) call->Write(chunk);
    context.TryCancel();
    v1::EvaluateStreamResponse answer;
    while (call->Read(&answer)) {
    }
    EXPECT_EQ(call->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
  EXPECT_EQ(server.evaluated(ggx_request(random_pairs(5000))).values_size(), 15'000);
}

}  // namespace
}  // namespace gonio::server::testing
