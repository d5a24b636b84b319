// What the client does when a server fails for a moment, for good, or makes no sense.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "client/support/retry_fixture.h"
#include "gonio/client/client.h"

namespace gonio::test {
namespace {

using client::Client;
using client::ClientOptions;
using client::Material;
using client::Report;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

TEST_F(Retry, CallIsRepeatedWhileTheServerIsUnavailable) {
  service().unary_failures = 3;
  auto report = evaluate(10);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->retries, 3);
  EXPECT_EQ(service().unary_calls, 4);
}

TEST_F(Retry, CallIsGivenUpAfterTheRetriesAllowed) {
  service().unary_failures = 100;
  auto options = quick();
  options.max_retries = 2;
  auto report = evaluate(10, options);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::unavailable);
  EXPECT_THAT(report.error().message, HasSubstr(server_->address()));
  EXPECT_EQ(service().unary_calls, 3);
}

TEST_F(Retry, WhatIsWrongIsNotRepeated) {
  service().unary_failures = 100;
  service().failure = {grpc::StatusCode::INVALID_ARGUMENT, "bad"};
  auto report = evaluate(10);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::invalid_argument);
  EXPECT_EQ(service().unary_calls, 1);
}

TEST_F(Retry, ExhaustedIsRepeatedOnlyWhenTheServerSaysWhen) {
  service().unary_failures = 1;
  service().failure = {grpc::StatusCode::RESOURCE_EXHAUSTED, "too large"};
  EXPECT_FALSE(evaluate(10).ok());
  EXPECT_EQ(service().unary_calls, 1);

  service().unary_failures = 1;
  service().pushback = "30";
  const auto start = std::chrono::steady_clock::now();
  auto report = evaluate(10);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->retries, 1);
  EXPECT_GE(std::chrono::steady_clock::now() - start, milliseconds(30));
}

TEST_F(Retry, NegativeUnreadableOrEndlessPushbackMeansNever) {
  for (const char* pushback : {"-1", "soon", "60001", "1000000000000000", "99999999999999999999"}) {
    service().unary_failures = 1;
    service().pushback = pushback;
    service().unary_calls = 0;
    EXPECT_FALSE(evaluate(10).ok()) << pushback;
    EXPECT_EQ(service().unary_calls, 1) << pushback;
  }
}

TEST_F(Retry, DeadlineEndsTheRetries) {
  service().unary_failures = 1000;
  auto options = quick();
  options.deadline = milliseconds(200);
  options.max_retries = 1000;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(evaluate(10, options).ok());
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(Retry, BrokenStreamIsTakenUpWhereItEnded) {
  service().break_after = 3;
  auto report = evaluate(1050);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->pairs, 1050U);
  EXPECT_EQ(report->retries, 1);
  EXPECT_EQ(service().streams, 2);
  EXPECT_EQ(service().materials, 2);    // once for each stream
  EXPECT_LT(service().chunks, 11 + 5);  // what had been answered was not sent again
}

TEST_F(Retry, StreamThatFailsForGoodIsAnError) {
  service().break_after = 3;
  service().failure = {grpc::StatusCode::INTERNAL, "broken"};
  auto report = evaluate(1050);
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().message, HasSubstr("broken"));
  EXPECT_EQ(service().streams, 1);
}

TEST_F(Retry, AnswersMayComeInAnyOrder) {
  service().reverse = true;
  service().last_sequence = 10;
  auto report = evaluate(1050);
  ASSERT_TRUE(report.ok()) << report.error().message;
}

TEST_F(Retry, RefusedChunksAreSentAgainOnTheSameStreamAfterOnePause) {
  service().chunk_failures = 4;
  service().chunk_error.set_code(grpc::StatusCode::RESOURCE_EXHAUSTED);
  service().chunk_error.set_message("the queue is full");
  auto options = quick();
  options.in_flight = 4;
  options.max_retries = 1;
  auto report = evaluate(1050, options);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->retries, 1);
  EXPECT_EQ(service().streams, 1);
  EXPECT_EQ(service().chunks, 4 + 11);

  service().chunk_failures = 1000;
  service().chunks = 0;
  report = evaluate(1050, options);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().message, "the queue is full");
  EXPECT_EQ(service().chunks, 4 + 4);
}

TEST_F(Retry, BadChunkIsAnErrorWithItsDetails) {
  service().chunk_failures = 1;
  service().chunk_error.set_code(grpc::StatusCode::RESOURCE_EXHAUSTED);
  service().chunk_error.set_message("too large");
  service().chunk_error.set_field("grid");
  service().chunk_error.set_value("7");
  service().chunk_error.set_allowed("6");
  auto report = evaluate(1050);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::resource_exhausted);
  EXPECT_EQ(report.error().field, "grid");
  EXPECT_EQ(report.error().value, "7");
  EXPECT_EQ(report.error().allowed, "6");
  EXPECT_EQ(service().streams, 1);
}

// Chunks this large are sent from the caller's memory: the call ends only when gRPC has given all
// of it back.
TEST_F(Retry, BadChunkOfLentMemoryDoesNotHang) {
  service().chunk_failures = 1;
  service().chunk_error.set_code(grpc::StatusCode::INVALID_ARGUMENT);
  auto options = quick();
  options.chunk_pairs = 10000;
  options.in_flight = 16;
  auto report = evaluate(500000, options);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::invalid_argument);
}

TEST_F(Retry, DeadlineInTheMiddleOfAStream) {
  service().delay = milliseconds(50);
  auto options = quick();
  options.deadline = milliseconds(250);
  auto report = evaluate(100000, options);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::deadline_exceeded) << report.error().message;
  EXPECT_THAT(report.error().message, HasSubstr(server_->address()));
}

TEST_F(Retry, AnswersThatMakeNoSenseAreErrors) {
  const std::vector<std::function<void(v1::EvaluateResponse&)>> spoilers = {
      [](auto& response) { response.set_channels(0); },
      [](auto& response) { response.set_channels(3); },
      [](auto& response) { response.set_channels(1); },
      [](auto& response) { response.mutable_values()->RemoveLast(); },
      [](auto& response) { response.add_values(1); },
      [](auto& response) { response.add_values_f64(1), response.clear_values(); },
      [](auto& response) { response.set_flags("x"); },
  };
  for (std::size_t i = 0; i < spoilers.size(); ++i) {
    // A new one: a stream that the client gave up may still be at work on the one before.
    server_ = std::make_unique<FakeServer>();
    service().spoil = spoilers[i];
    for (const std::size_t count : {10U, 1050U}) {
      auto report = evaluate(count);
      ASSERT_FALSE(report.ok()) << i;
      EXPECT_THAT(report.error().message, HasSubstr("makes no sense")) << i;
    }
  }
}

TEST_F(Retry, ErrorOfSourceOrSinkIsPassedOn) {
  auto client = Client::connect(server_->address(), quick());
  const RandomPairs<float> pairs(100);
  const Error wanted{ErrorCode::data_loss, "mine", "f", "v", "a"};
  int given = 0;
  const client::PairSource<float> source = [&](std::span<float> wi,
                                               std::span<float> wo) -> Result<std::size_t> {
    if (++given == 4) return wanted;
    std::copy(pairs.wi.begin(), pairs.wi.end(), wi.begin());
    std::copy(pairs.wo.begin(), pairs.wo.end(), wo.begin());
    return std::size_t{100};
  };
  const client::ChunkSink<float, float> accept = [](const auto&) { return Ok{}; };
  auto report = client->evaluate_chunks<float, float>(Material::named("x"), source, accept);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().message, "mine");

  given = -1000;
  const client::ChunkSink<float, float> refuse = [&](const auto&) { return wanted; };
  report = client->evaluate_chunks<float, float>(Material::named("x"), source, refuse);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().message, "mine");
}

}  // namespace
}  // namespace gonio::test
