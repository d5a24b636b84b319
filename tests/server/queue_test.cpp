// A full queue refuses at once and says when to come back; what is small does not need it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/support/busy_pool.h"
#include "server/support/stream_client.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

TEST(Queue, AFullOneRefusesWithAPushback) {
  BusyService service(1);
  grpc::ClientContext context;
  v1::EvaluateResponse response;
  const grpc::Status status =
      service.stub->Evaluate(&context, ggx_request(random_pairs(5000)), &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(status.error_message(), HasSubstr("at most 1 batches"));
  const auto& trailers = context.GetServerTrailingMetadata();
  const auto pushback = trailers.find(wire::kRetryPushback);
  ASSERT_NE(pushback, trailers.end());
  EXPECT_GT(std::stoi(std::string(pushback->second.data(), pushback->second.size())), 0);
}

TEST(Queue, SmallBatchesAreComputedAllTheSame) {
  BusyService service(1);
  grpc::ClientContext context;
  v1::EvaluateResponse response;
  EXPECT_TRUE(service.stub->Evaluate(&context, ggx_request(random_pairs(1000)), &response).ok());
  EXPECT_EQ(response.values_size(), 3000);
}

TEST(Queue, AStreamsChunkIsRefusedAloneAndMayBeSentAgain) {
  BusyService service(1);
  const auto refused = stream(*service.stub, chunked(random_pairs(5000), 5000));
  EXPECT_TRUE(refused.status.ok());
  EXPECT_EQ(refused.answers.at(0).error().code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  service.free();
  while (service.pool().jobs() > 0) std::this_thread::yield();
  const auto again = stream(*service.stub, chunked(random_pairs(5000), 5000));
  EXPECT_TRUE(again.answers.at(0).has_evaluate());
}

TEST(Queue, FullMemoryRefusesWithAPushbackUntilAnAnswerIsSent) {
  // The first is alone and fits; its request and answer are larger than this.
  BusyService service(3, 100'000);
  const auto request = ggx_request(random_pairs(5000));
  std::thread first([&] {
    grpc::ClientContext context;
    v1::EvaluateResponse response;
    EXPECT_TRUE(service.stub->Evaluate(&context, request, &response).ok());
  });
  while (service.pool().jobs() < 2) std::this_thread::yield();
  grpc::ClientContext refused;
  v1::EvaluateResponse response;
  const grpc::Status status = service.stub->Evaluate(&refused, request, &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(status.error_message(), HasSubstr("of 100000 bytes"));
  EXPECT_EQ(refused.GetServerTrailingMetadata().count(wire::kRetryPushback), 1U);
  service.free();
  first.join();
  while (service.memory().held() > 0) std::this_thread::yield();
  const auto again = stream(*service.stub, chunked(random_pairs(5000), 5000));
  EXPECT_TRUE(again.answers.at(0).has_evaluate());
  while (service.memory().held() > 0) std::this_thread::yield();
}

TEST(Queue, QueuedJobsAreDoneWhenTheirTurnComes) {
  BusyService service(3);
  const PairArrays pairs = random_pairs(5000);
  std::vector<std::thread> clients;
  std::atomic<int> answered{0};
  for (int i = 0; i < 2; ++i) {
    clients.emplace_back([&] {
      grpc::ClientContext context;
      v1::EvaluateResponse response;
      if (service.stub->Evaluate(&context, ggx_request(pairs), &response).ok()) ++answered;
    });
  }
  while (service.pool().jobs() < 3) std::this_thread::yield();
  EXPECT_EQ(answered, 0);
  service.free();
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(answered, 2);
}

}  // namespace
}  // namespace gonio::server::testing
