// Results depend on nothing but pair, material, precision and instruction set: bit for bit, however
// they travel.
#include <gtest/gtest.h>

#include "measured/temp_folder.h"
#include "server/support/harness.h"
#include "server/support/stream_client.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;

std::shared_ptr<grpc::Channel> channel_to(const std::string& target) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(-1);
  return grpc::CreateCustomChannel(target, grpc::InsecureChannelCredentials(), arguments);
}

class Sameness : public ::testing::TestWithParam<int> {};  // compute threads

TEST_P(Sameness, OverChunksAndTransports) {
  const TempFolder folder;
  ServerOptions options;
  options.addresses = {"127.0.0.1:0", "unix:" + (folder / "s").string()};
  options.threads = GetParam();
  TestServer server(options);
  const PairArrays pairs = random_pairs(30'000);
  const auto expected = core_values<float, float>(core_ggx(), pairs.wi, pairs.wo);
  const std::shared_ptr<grpc::Channel> channels[] = {
      server.server->in_process_channel(),
      channel_to("127.0.0.1:" + std::to_string(server.server->port())),
      channel_to(options.addresses[1])};
  for (const auto& channel : channels) {
    const auto stub = v1::GonioService::NewStub(channel);
    grpc::ClientContext context;
    v1::EvaluateResponse response;
    ASSERT_TRUE(stub->Evaluate(&context, ggx_request(pairs), &response).ok());
    EXPECT_EQ(std::vector<float>(response.values().begin(), response.values().end()), expected);
    for (const std::size_t size : {37UL, 1024UL, 4096UL, 10'007UL, 30'000UL}) {
      const StreamResult result = stream(*stub, chunked(pairs, size));
      ASSERT_TRUE(result.status.ok()) << result.status.error_message();
      EXPECT_EQ(joined(result), expected) << "chunks of " << size;
    }
  }
}

TEST_P(Sameness, OnePairAtATime) {
  ServerOptions options;
  options.threads = GetParam();
  TestServer server(options);
  const PairArrays pairs = random_pairs(300);
  const auto expected = core_values<float, float>(core_ggx(), pairs.wi, pairs.wo);
  EXPECT_EQ(joined(stream(*server.stub, chunked(pairs, 1))), expected);
}

INSTANTIATE_TEST_SUITE_P(Threads, Sameness, ::testing::Values(1, 2, 5));

}  // namespace
}  // namespace gonio::server::testing
