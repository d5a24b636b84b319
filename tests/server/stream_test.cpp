// EvaluateStream: chunks, slots, errors that stay in their chunk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/support/harness.h"
#include "server/support/raw_call.h"
#include "server/support/stream_client.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

v1::EvaluateStreamRequest chunk(std::uint64_t sequence, std::uint32_t slot,
                                const PairArrays& pairs) {
  v1::EvaluateStreamRequest request;
  request.set_sequence(sequence);
  request.set_slot(slot);
  *request.mutable_evaluate() = request_for(pairs, 0, pairs.size());
  return request;
}

v1::EvaluateStreamRequest with_ggx(v1::EvaluateStreamRequest request, double alpha) {
  set_ggx(*request.mutable_evaluate()->mutable_material(), alpha);
  return request;
}

std::vector<float> values(const StreamResult& result, std::uint64_t sequence) {
  const auto& found = result.answers.at(sequence).evaluate().values();
  return {found.begin(), found.end()};
}

TEST(Stream, NoChunksNoAnswers) {
  TestServer server;
  const StreamResult result = stream(*server.stub, {});
  EXPECT_TRUE(result.status.ok());
  EXPECT_TRUE(result.answers.empty());
}

TEST(Stream, EachSlotKeepsItsOwnMaterial) {
  TestServer server;
  const PairArrays pairs = random_pairs(50);
  const auto result =
      stream(*server.stub, {with_ggx(chunk(7, 0, pairs), 0.2), with_ggx(chunk(1, 255, pairs), 0.4),
                            chunk(3, 0, pairs), chunk(1ULL << 60, 255, pairs),
                            with_ggx(chunk(4, 0, pairs), 0.6), chunk(5, 0, pairs)});
  ASSERT_TRUE(result.status.ok());
  ASSERT_EQ(result.answers.size(), 6U);
  const auto expected = [&](double alpha) {
    return core_values<float, float>(core_ggx(alpha), pairs.wi, pairs.wo);
  };
  EXPECT_EQ(values(result, 7), expected(0.2));
  EXPECT_EQ(values(result, 3), expected(0.2));
  EXPECT_EQ(values(result, 1), expected(0.4));
  EXPECT_EQ(values(result, 1ULL << 60), expected(0.4));
  EXPECT_EQ(values(result, 4), expected(0.6));
  EXPECT_EQ(values(result, 5), expected(0.6));
}

TEST(Stream, ABadChunkIsAnsweredAndTheStreamGoesOn) {
  TestServer server;
  const PairArrays pairs = random_pairs(50);
  auto broken = chunk(1, 0, pairs);
  broken.mutable_evaluate()->mutable_pairs()->add_wi(1);
  auto far_slot = with_ggx(chunk(3, 256, pairs), 0.2);
  const auto result =
      stream(*server.stub, {with_ggx(chunk(0, 0, pairs), 0.2), broken, chunk(2, 0, pairs), far_slot,
                            chunk(4, 9, pairs), chunk(5, 0, pairs)});
  ASSERT_TRUE(result.status.ok());
  ASSERT_EQ(result.answers.size(), 6U);
  EXPECT_EQ(values(result, 2), values(result, 0));
  EXPECT_EQ(values(result, 5), values(result, 0));
  EXPECT_EQ(result.answers.at(1).error().field(), "pairs.wi");
  EXPECT_EQ(result.answers.at(1).error().code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(result.answers.at(3).error().field(), "slot");
  EXPECT_EQ(result.answers.at(3).error().value(), "256");
  EXPECT_THAT(result.answers.at(4).error().message(), HasSubstr("slot 9"));
}

TEST(Stream, ABadMaterialDoesNotLeaveTheOldOneInItsSlot) {
  TestServer server;
  const PairArrays pairs = random_pairs(50);
  const auto result =
      stream(*server.stub, {with_ggx(chunk(0, 0, pairs), 0.2), with_ggx(chunk(1, 0, pairs), 99),
                            chunk(2, 0, pairs), with_ggx(chunk(3, 0, pairs), 0.2)});
  EXPECT_TRUE(result.answers.at(0).has_evaluate());
  EXPECT_THAT(result.answers.at(1).error().field(), HasSubstr("alpha"));
  EXPECT_EQ(result.answers.at(2).error().message(), result.answers.at(1).error().message());
  EXPECT_EQ(values(result, 3), values(result, 0));
}

TEST(Stream, AChunkWithBadPairsStillDefinesItsSlot) {
  TestServer server;
  const PairArrays pairs = random_pairs(50);
  auto broken = with_ggx(chunk(0, 0, pairs), 0.2);
  broken.mutable_evaluate()->mutable_pairs()->add_wi(1);
  const auto result = stream(*server.stub, {broken, chunk(1, 0, pairs)});
  EXPECT_TRUE(result.answers.at(0).has_error());
  EXPECT_TRUE(result.answers.at(1).has_evaluate());
}

TEST(Stream, BytesThatAreNoChunkEndTheStream) {
  TestServer server;
  const grpc::Slice garbage("\xff\xff\xff");
  const auto [status, response] =
      raw_call(server.server->in_process_channel(), "/gonio.v1.GonioService/EvaluateStream",
               grpc::ByteBuffer(&garbage, 1));
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("EvaluateStreamRequest"));
}

TEST(Stream, TwoAtOnceOneWithBadPairsGetWhatEachGetsAlone) {
  TestServer server;
  const PairArrays good = random_pairs(200'000, 1);
  PairArrays bad = random_pairs(200'000, 2);
  for (std::size_t i = 0; i < bad.wi.size(); i += 97) bad.wi[i] = i % 2 == 0 ? NAN : -1e30F;
  const auto good_chunks = chunked(good, 9'000, 0.1);
  auto bad_chunks = chunked(bad, 11'000, 0.3);
  bad_chunks[3].mutable_evaluate()->mutable_pairs()->add_wo(0);
  const StreamResult good_alone = stream(*server.stub, good_chunks),
                     bad_alone = stream(*server.stub, bad_chunks);
  StreamResult good_beside, bad_beside;
  std::thread other([&] { bad_beside = stream(*server.stub, bad_chunks); });
  good_beside = stream(*server.stub, good_chunks);
  other.join();
  EXPECT_EQ(joined(good_alone), joined(good_beside));
  ASSERT_EQ(bad_alone.answers.size(), bad_beside.answers.size());
  for (const auto& [sequence, alone] : bad_alone.answers) {
    const auto& beside = bad_beside.answers.at(sequence);
    EXPECT_EQ(alone.error().message(), beside.error().message());
    EXPECT_EQ(alone.evaluate().flags(), beside.evaluate().flags());
    EXPECT_TRUE(std::equal(alone.evaluate().values().begin(), alone.evaluate().values().end(),
                           beside.evaluate().values().begin(), beside.evaluate().values().end()));
  }
  EXPECT_TRUE(bad_alone.answers.at(3).has_error());
  EXPECT_FALSE(bad_alone.answers.at(0).evaluate().flags().empty());
}

TEST(Stream, ASlowReaderHoldsTheServerBack) {
  // 128 answers of 768 KiB; the client reads nothing until it cannot write on.
  ServerOptions options;
  options.addresses = {"127.0.0.1:0"};
  TestServer server(options);
  const auto stub = v1::GonioService::NewStub(grpc::CreateChannel(
      "127.0.0.1:" + std::to_string(server.server->port()), grpc::InsecureChannelCredentials()));
  const PairArrays pairs = random_pairs(65'536);
  grpc::ClientContext context;
  const auto call = stub->EvaluateStream(&context);
  std::atomic<int> written{0};
  std::thread writer([&] {
    for (std::uint64_t i = 0; i < 128 && call->Write(with_ggx(chunk(i, 0, pairs), 0.2)); ++i)
      ++written;
    call->WritesDone();
  });
  int stood_at = -1;
  while (written == 0 || written != stood_at) {
    stood_at = written;
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
  }
  EXPECT_LT(stood_at, 64);
  int answers = 0;
  for (v1::EvaluateStreamResponse answer; call->Read(&answer);) {
    ++answers;
    EXPECT_EQ(answer.evaluate().values_size(), 3 * 65'536);
  }
  writer.join();
  EXPECT_TRUE(call->Finish().ok());
  EXPECT_EQ(answers, 128);
  EXPECT_EQ(written, 128);
}

}  // namespace
}  // namespace gonio::server::testing
