// What the client says when the caller is wrong, or the server is not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <string>
#include <vector>

#include "client/support/pairs.h"
#include "client/support/server_fixture.h"
#include "gonio/client/client.h"

namespace gonio::test {
namespace {

using client::Client;
using client::ClientOptions;
using client::Material;
using std::chrono::milliseconds;
using ::testing::AllOf;
using ::testing::HasSubstr;

class ErrorTest : public ServerFixture {};

TEST_F(ErrorTest, WrongLengths) {
  const auto client = connect("tcp");
  std::vector<float> wi(9), wo(9), values(9);
  std::vector<std::uint8_t> flags(3);
  const auto message = [&](std::size_t wi_size, std::size_t wo_size, std::size_t value_size,
                           std::size_t flag_size) {
    wi.resize(wi_size), wo.resize(wo_size), values.resize(value_size), flags.resize(flag_size);
    auto report = client.evaluate(ggx(), wi, wo, values, flags);
    EXPECT_FALSE(report.ok());
    EXPECT_EQ(report.error().code, ErrorCode::invalid_argument);
    return report.error().message;
  };
  EXPECT_THAT(message(8, 8, 9, 3), HasSubstr("length of wi is 8"));
  EXPECT_THAT(message(9, 6, 9, 3), HasSubstr("length of wo is 6"));
  EXPECT_THAT(message(9, 9, 8, 3), HasSubstr("length of values is 8"));
  EXPECT_THAT(message(9, 9, 0, 3), HasSubstr("length of values is 0"));
  EXPECT_THAT(message(9, 9, 3 * 65, 3), HasSubstr("length of values is 195"));
  EXPECT_THAT(message(9, 9, 9, 2), HasSubstr("length of flags is 2"));
  // Only the server knows that this material has three channels.
  EXPECT_THAT(message(9, 9, 6, 3), HasSubstr("allowed: 3 pairs x 3 channels of this material = 9"));
}

TEST_F(ErrorTest, WrongOptions) {
  for (const char* address :
       {"", "localhost", "localhost:", ":80", "localhost:0", "host:65536", "::1:80",
        "http://host:80", "host:80/x", "unix:", "[]:80", "unix://x", "unix-abstract:80"}) {
    const auto client = Client::connect(address);
    ASSERT_FALSE(client.ok()) << address;
    EXPECT_THAT(client.error().message, AllOf(HasSubstr(address), HasSubstr("host:port")));
  }
  for (const char* address : {"localhost:80", "[::1]:80", "unix:/x", "unix:x", "unix:a#b"}) {
    EXPECT_TRUE(Client::connect(address).ok()) << address;
  }
  for (auto change :
       {+[](ClientOptions& o) { o.chunk_pairs = 0; }, +[](ClientOptions& o) { o.in_flight = 0; },
        +[](ClientOptions& o) { o.max_retries = -1; },
        +[](ClientOptions& o) { o.backoff = milliseconds(-1); },
        +[](ClientOptions& o) { o.connect_timeout = milliseconds(0); },
        +[](ClientOptions& o) { o.deadline = milliseconds(-1); }}) {
    ClientOptions options;
    change(options);
    EXPECT_FALSE(Client::connect("localhost:1", options).ok());
  }
}

TEST_F(ErrorTest, WrongGrids) {
  const auto client = connect("tcp");
  std::vector<float> values;
  client::Grid grid;
  grid.theta_i = grid.phi_i = grid.theta_o = {0};
  auto report = client.evaluate(ggx(), grid, values);
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().message, HasSubstr("grid.phi_o is empty"));
  grid.phi_o = {0};
  grid.theta_h = {0};
  report = client.evaluate(ggx(), grid, values);
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().message, HasSubstr("both kinds"));
  grid.theta_h.clear();
  grid.theta_i = {std::numeric_limits<double>::quiet_NaN()};
  values.resize(3);
  report = client.evaluate(ggx(), grid, values);
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().message, HasSubstr("theta_i"));
}

TEST_F(ErrorTest, MaterialErrorsNameFieldValueAndBounds) {
  const auto client = connect("tcp");
  const RandomPairs<float> pairs(10);
  std::vector<float> values(10);
  auto report =
      client.evaluate(Material::model("ggx", {{"alpha_x", 7.0}}), pairs.wi, pairs.wo, values);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::invalid_argument);
  EXPECT_EQ(report.error().field, "material.parameters.alpha_x");
  EXPECT_EQ(report.error().value, "7");
  EXPECT_THAT(report.error().allowed, HasSubstr("1"));
  report = client.evaluate(Material::model("gggx"), pairs.wi, pairs.wo, values);
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().message, HasSubstr("gggx"));
}

TEST_F(ErrorTest, BadMaterialInAStream) {
  ClientOptions options;
  options.chunk_pairs = 10;
  const RandomPairs<float> pairs(1000);
  std::vector<float> values(1000);
  auto report =
      connect("tcp", options)
          .evaluate(Material::model("ggx", {{"alpha_x", 7.0}}), pairs.wi, pairs.wo, values);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().field, "material.parameters.alpha_x");
}

TEST(DeadServer, IsNamedAndDoesNotHang) {
  ClientOptions options;
  options.max_retries = 1;
  options.backoff = milliseconds(1);
  const RandomPairs<float> pairs(200000);
  std::vector<float> values(200000);
  for (const char* address : {"127.0.0.1:1", "unix:/nowhere/gonio.sock"}) {
    auto client = Client::connect(address, options);
    ASSERT_TRUE(client.ok());
    EXPECT_FALSE(client->list_models().ok());
    for (const std::size_t count : {1U, 200000U}) {
      auto report = client->evaluate(Material::named("x"), {pairs.wi.data(), 3 * count},
                                     {pairs.wo.data(), 3 * count}, {values.data(), count});
      ASSERT_FALSE(report.ok());
      EXPECT_EQ(report.error().code, ErrorCode::unavailable) << report.error().message;
      EXPECT_THAT(report.error().message, HasSubstr(address));
    }
  }
}

// 192.0.2.1 belongs to no one (RFC 5737): packets to it vanish, or are refused at once.
TEST(DeadServer, SilentAddressEndsWithTheDeadline) {
  ClientOptions options;
  options.deadline = milliseconds(300);
  auto client = Client::connect("192.0.2.1:50051", options);
  auto models = client->list_models();
  ASSERT_FALSE(models.ok());
  EXPECT_TRUE(models.error().code == ErrorCode::deadline_exceeded ||
              models.error().code == ErrorCode::unavailable);
  EXPECT_THAT(models.error().message, HasSubstr("192.0.2.1:50051"));
}

TEST_F(ErrorTest, ServerThatStopsInTheMiddleOfAStream) {
  ClientOptions options;
  options.max_retries = 1;
  options.backoff = milliseconds(1);
  options.chunk_pairs = 64;
  const auto client = connect("tcp", options);
  const std::string address = tcp();
  const RandomPairs<float> pairs(64);
  std::size_t chunks = 0;
  const client::PairSource<float> endless = [&](std::span<float> wi, std::span<float> wo) {
    std::copy(pairs.wi.begin(), pairs.wi.end(), wi.begin());
    std::copy(pairs.wo.begin(), pairs.wo.end(), wo.begin());
    return Result<std::size_t>(64);
  };
  const client::ChunkSink<float, float> sink = [&](const auto&) {
    if (++chunks == 50) server_->shutdown(milliseconds(0));
    return Ok{};
  };
  auto report = client.evaluate_chunks<float, float>(ggx(), endless, sink);
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().message, HasSubstr(address));
  EXPECT_GE(chunks, 50U);
}

TEST_F(ErrorTest, ServerThatComesBackIsUsedAgain) {
  ClientOptions options;
  options.max_retries = 20;
  options.backoff = milliseconds(20);
  options.chunk_pairs = 64;
  const auto client = connect("unix", options);
  const RandomPairs<float> pairs(64 * 400);
  std::vector<float> expected(3 * 64 * 400), values;
  ASSERT_TRUE(client.evaluate(ggx(), pairs.wi, pairs.wo, expected).ok());
  std::size_t given = 0, chunks = 0;
  const client::PairSource<float> source = [&](std::span<float> wi, std::span<float> wo) {
    const std::size_t count = std::min<std::size_t>(64, 64 * 400 - given);
    std::copy_n(&pairs.wi[3 * given], 3 * count, wi.begin());
    std::copy_n(&pairs.wo[3 * given], 3 * count, wo.begin());
    given += count;
    return Result<std::size_t>(count);
  };
  const client::ChunkSink<float, float> sink = [&](const auto& chunk) {
    if (++chunks == 50) {
      server_.reset();
      start();
    }
    values.insert(values.end(), chunk.values.begin(), chunk.values.end());
    return Ok{};
  };
  auto report = client.evaluate_chunks<float, float>(ggx(), source, sink);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_GE(report->retries, 1);
  EXPECT_EQ(values, expected);
}

}  // namespace
}  // namespace gonio::test
