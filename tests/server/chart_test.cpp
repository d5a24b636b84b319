// Chart: the core's own tables over the wire, what is refused, what is cancelled.
#include <gmock/gmock.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <optional>

#include "effort.h"
#include "server/messages/chart_request.h"
#include "server/support/progress_client.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::kSlower;
using gonio::testing::WorkClock;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

// Of parts whose numbers are no times: the same whenever they are found.
v1::ChartRequest directions_chart() {
  v1::ChartRequest request;
  request.add_parts("directions");
  request.set_pairs_at_a_place(30);
  request.set_seed(7);
  return request;
}

TEST(ChartCall, IsTheCoresOwnChart) {
  TestServer server;
  const auto answer = ask(server, directions_chart());
  ASSERT_TRUE(answer.status.ok()) << answer.status.error_message();
  ASSERT_TRUE(answer.result);
  chart::Options options;
  options.pairs = 30;
  options.seed = 7;
  const auto own = chart::measure({{"directions"}, std::nullopt}, options);
  ASSERT_TRUE(own);
  EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(
      *answer.result, to_wire(*own, chart::this_machine())));
}

TEST(ChartCall, MeasuresTimesInTheWayThatIsAskedFor) {
  TestServer server;
  v1::ChartRequest request;
  request.add_parts("approximations");
  request.set_repetitions(2);
  request.set_seconds(1e-6);
  request.set_pairs_at_a_place(10);
  const auto answer = ask(server, request);
  ASSERT_TRUE(answer.result) << answer.status.error_message();
  ASSERT_EQ(answer.result->tables_size(), 3);
  const v1::ChartTable& table = answer.result->tables(0);
  EXPECT_EQ(table.name(), "fresnel");
  for (int c = 0; c < table.columns_size(); ++c) {
    if (table.columns(c).name() != "repetitions") continue;
    EXPECT_EQ(table.rows(0).cells(c).number(), 2);
  }
}

TEST(ChartCall, SaysWhatIsWrong) {
  TestServer server;
  const auto with = [&](const auto& change) {
    v1::ChartRequest request = directions_chart();
    change(request);
    return refused(server, request).field;
  };
  EXPECT_EQ(with([](auto& r) { r.add_parts("wire"); }), "parts[1]");
  EXPECT_EQ(with([](auto& r) { r.set_repetitions(4'000'000'000U); }), "repetitions");
  EXPECT_EQ(with([](auto& r) { r.set_seconds(1); }), "seconds");
  EXPECT_EQ(with([](auto& r) { r.set_seconds(std::numeric_limits<double>::quiet_NaN()); }),
            "seconds");
  EXPECT_EQ(with([](auto& r) { r.set_pairs_at_a_place(100'001); }), "pairs_at_a_place");
  EXPECT_EQ(with([](auto& r) { r.mutable_measured()->set_name("nothing"); }), "measured.name");
  EXPECT_EQ(with([](auto& r) { r.mutable_measured()->set_model("ggx"); }), "measured");
  EXPECT_EQ(with([](auto& r) { r.mutable_pairs()->set_channels(65); }), "pairs.channels");
  EXPECT_EQ(with([](auto& r) {
              r.mutable_pairs()->set_channels(1);
              r.mutable_pairs()->add_values(1);
            }),
            "pairs.values");
  EXPECT_EQ(with([](auto& r) {
              r.add_parts("resolution");
              r.mutable_pairs()->set_channels(1);
            }),
            "parts");
}

// A chart that takes half a minute.
v1::ChartRequest long_chart() {
  v1::ChartRequest request;
  request.add_parts("models");
  request.set_pairs_at_a_place(20'000);
  request.set_repetitions(200);
  return request;
}

TEST(ChartCall, EndsSoonWhenItIsCancelled) {
  ServerOptions options;
  options.fit_threads = 1;
  TestServer server(options);
  EXPECT_EQ(ask(server, long_chart(), true).status.error_code(), grpc::StatusCode::CANCELLED);
  // The only thread is soon free for the next.
  const auto begin = WorkClock::now();
  EXPECT_TRUE(ask(server, directions_chart()).status.ok());
  EXPECT_LT(WorkClock::now() - begin, kSlower * 2s);
}

TEST(ChartCall, KeepsTheServersOwnDeadline) {
  ServerOptions options;
  options.longest_fit = 200ms;
  TestServer server(options);
  const auto begin = WorkClock::now();
  const auto answer = ask(server, long_chart());
  EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  EXPECT_THAT(answer.status.error_message(), HasSubstr("the chart was not done"));
  EXPECT_LT(WorkClock::now() - begin, kSlower * 2s);
}

}  // namespace
}  // namespace gonio::server::testing
