// A client of a server that fails when it is told to. Thread safety: one test at a time.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <vector>

#include "client/support/fake_service.h"
#include "client/support/pairs.h"
#include "gonio/client/client.h"

namespace gonio::test {

inline client::ClientOptions quick() {
  client::ClientOptions options;
  options.backoff = std::chrono::milliseconds(2);
  options.chunk_pairs = 100;
  return options;
}

class Retry : public ::testing::Test {
 protected:
  // Evaluates `count` pairs and checks every value of a success.
  Result<client::Report> evaluate(std::size_t count,
                                  const client::ClientOptions& options = quick()) {
    auto client = client::Client::connect(server_->address(), options);
    if (!client) return client.error();
    const RandomPairs<float> pairs(count);
    std::vector<float> values(count * kFakeChannels, -1);
    std::vector<std::uint8_t> flags(count, 255);
    auto report = client->evaluate(client::Material::named("x"), pairs.wi, pairs.wo, values, flags);
    if (!report) return report;
    for (std::size_t i = 0; i < count; ++i) {
      for (int c = 0; c < kFakeChannels; ++c) {
        const std::size_t at = i * kFakeChannels + static_cast<std::size_t>(c);
        EXPECT_EQ(values[at], fake_value(pairs.wi[3 * i + 2], pairs.wo[3 * i + 2], c)) << i;
      }
      EXPECT_EQ(flags[i], 0);
    }
    return report;
  }

  FakeService& service() {
    server_->handlers_ended();
    return server_->service;
  }
  std::unique_ptr<FakeServer> server_ = std::make_unique<FakeServer>();
};

}  // namespace gonio::test
