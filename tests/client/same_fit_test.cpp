// A fit's bits depend on its data, its options and the processor's instruction set, on nothing
// else.
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <thread>

#include "client/support/fit_fixture.h"
#include "gonio/v1/fit.pb.h"

namespace gonio::test {
namespace {

using google::protobuf::util::MessageDifferencer;
using SameFit = FitFixture;

// All of a result but the time that it took.
v1::FitResult without_times(const client::FitResult& result) {
  v1::FitResult message;
  EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(result.json, &message).ok());
  message.mutable_certificate()->clear_cpu_seconds();
  for (auto& stage : *message.mutable_certificate()->mutable_stages()) stage.clear_cpu_seconds();
  return message;
}

TEST_F(SameFit, OnOneThreadAndOnTwoAndBesideAnother) {
  const Measured measured(3000);
  client::FitOptions options;
  options.seed = 7;
  options.fit_pairs = 2000;  // so that the seed chooses
  options.scan_pairs = 500;
  options.starts = 3;
  v1::FitResult one, two[2];
  start_with([](server::ServerOptions& server) { server.threads = server.fit_threads = 1; });
  const auto alone = connect("tcp").fit(measured.data(), form(), options);
  ASSERT_TRUE(alone.ok()) << alone.error().message;
  one = without_times(*alone);
  start_with([](server::ServerOptions& server) { server.threads = server.fit_threads = 2; });
  const auto fit = [&](v1::FitResult& found) {
    const auto result = connect("unix").fit(measured.data(), form(), options);
    ASSERT_TRUE(result.ok()) << result.error().message;
    found = without_times(*result);
  };
  std::thread other(fit, std::ref(two[0]));
  fit(two[1]);
  other.join();
  EXPECT_TRUE(MessageDifferencer::Equals(one, two[0]));  // numbers to their last bit
  EXPECT_TRUE(MessageDifferencer::Equals(one, two[1]));
  options.seed = 8;
  fit(two[0]);
  EXPECT_FALSE(MessageDifferencer::Equals(one, two[0]));  // the comparison can fail
}

}  // namespace
}  // namespace gonio::test
