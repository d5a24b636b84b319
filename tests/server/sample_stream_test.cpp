// SampleStream: chunks of samples, the bits of one call.
#include <gtest/gtest.h>

#include <map>

#include "server/support/sample_requests.h"
#include "server/support/stream_client.h"

namespace gonio::server::testing {
namespace {

using Answers = std::map<std::uint64_t, v1::SampleStreamResponse>;

Answers stream(TestServer& server, const std::vector<v1::SampleStreamRequest>& chunks) {
  grpc::ClientContext context;
  auto result = exchange(*server.stub->SampleStream(&context), chunks);
  EXPECT_TRUE(result.status.ok()) << result.status.error_message();
  return std::move(result.answers);
}

// Runs of 1000 samples of one request, the material with the first.
std::vector<v1::SampleStreamRequest> chunked(const v1::SampleRequest& request,
                                             std::uint64_t samples) {
  std::vector<v1::SampleStreamRequest> chunks;
  for (std::uint64_t first = 0; first < samples; first += 1000) {
    v1::SampleStreamRequest chunk;
    chunk.set_sequence(chunks.size());
    chunk.set_slot(7);
    *chunk.mutable_sample() = request;
    if (first > 0) chunk.mutable_sample()->clear_material();
    chunk.mutable_sample()->set_first(first);
    chunk.mutable_sample()->set_count(1000);
    chunks.push_back(std::move(chunk));
  }
  return chunks;
}

TEST(SampleStream, IsTheOneCallInPieces) {
  TestServer server;
  v1::SampleRequest request = sample_request(random_directions(5), 2000);
  request.set_seed(11);
  const v1::SampleResponse whole = sampled(server, request);
  const Answers answers = stream(server, chunked(request, 10'000));
  ASSERT_EQ(answers.size(), 10U);
  std::vector<float> wo, pdf, weights;
  std::uint64_t lost = 0;
  for (const auto& [sequence, answer] : answers) {
    ASSERT_TRUE(answer.has_sample()) << answer.error().message();
    const v1::SampleResponse& piece = answer.sample();
    wo.insert(wo.end(), piece.wo().begin(), piece.wo().end());
    pdf.insert(pdf.end(), piece.pdf().begin(), piece.pdf().end());
    weights.insert(weights.end(), piece.weights().begin(), piece.weights().end());
    lost += piece.lost();
  }
  EXPECT_EQ(wo, vector_of<float>(whole.wo()));
  EXPECT_EQ(pdf, vector_of<float>(whole.pdf()));
  EXPECT_EQ(weights, vector_of<float>(whole.weights()));
  EXPECT_EQ(lost, whole.lost());
}

TEST(SampleStream, ABadChunkSpoilsNoOther) {
  TestServer server;
  auto chunks = chunked(sample_request(random_directions(3), 1000), 3000);
  chunks[1].mutable_sample()->set_per_wi(0);
  v1::SampleStreamRequest unknown;
  unknown.set_sequence(50);
  unknown.set_slot(8);
  *unknown.mutable_sample() = chunks[2].sample();
  chunks.push_back(unknown);
  const Answers answers = stream(server, chunks);
  ASSERT_EQ(answers.size(), 4U);
  EXPECT_TRUE(answers.at(0).has_sample());
  EXPECT_EQ(answers.at(1).error().field(), "per_wi");
  EXPECT_TRUE(answers.at(2).has_sample());
  EXPECT_EQ(answers.at(50).error().field(), "material");
}

}  // namespace
}  // namespace gonio::server::testing
