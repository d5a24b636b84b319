// What the client does when a server fails in the middle of samples, or makes no sense.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "client/support/retry_fixture.h"

namespace gonio::test {
namespace {

using client::Client;
using client::Material;
using client::Report;
using ::testing::HasSubstr;

// 40 directions, whose x says which one it is, with 25 samples each.
class SampleRetry : public Retry {
 protected:
  static constexpr std::size_t kDirections = 40, kPerWi = 25;

  SampleRetry() : wi_(3 * kDirections), wo_(3 * kSamples), pdf_(kSamples), weights_(kSamples) {
    for (std::size_t i = 0; i < kDirections; ++i) wi_[3 * i] = static_cast<float>(i);
  }

  Result<Report> sample() {
    auto client = Client::connect(server_->address(), quick());
    if (!client) return client.error();
    client::SampleBatch<float> batch;
    batch.wi = wi_;
    batch.per_wi = kPerWi;
    return client->sample(Material::named("x"), batch, {wo_, pdf_, weights_, {}});
  }

  static constexpr std::size_t kSamples = kDirections * kPerWi;
  std::vector<float> wi_, wo_, pdf_, weights_;
};

TEST_F(SampleRetry, WhatABrokenStreamLostIsDrawnAgain) {
  service().break_after = 3;
  auto report = sample();
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->retries, 1);
  EXPECT_EQ(service().streams, 2);
  for (std::size_t i = 0; i < kSamples; ++i) {
    EXPECT_EQ(pdf_[i], static_cast<float>(i));
    EXPECT_EQ(weights_[i], static_cast<float>(i / kPerWi));
  }
}

TEST_F(SampleRetry, AnswersOfWrongLengthsAreErrors) {
  const std::vector<std::function<void(gonio::v1::SampleResponse&)>> spoils = {
      [](auto& samples) { samples.mutable_pdf()->RemoveLast(); },
      [](auto& samples) { samples.mutable_wo()->RemoveLast(); },
      [](auto& samples) { samples.add_weights(1); }, [](auto& samples) { samples.set_flags("x"); },
      [](auto& samples) { samples.set_channels(0); }};
  for (const auto& spoil : spoils) {
    server_ = std::make_unique<FakeServer>();  // the one before may still be at work
    service().spoil_samples = spoil;
    auto report = sample();
    ASSERT_FALSE(report.ok());
    EXPECT_THAT(report.error().message, HasSubstr("makes no sense"));
  }
}

}  // namespace
}  // namespace gonio::test
