// Requests for assessments and charts: what a caller sets reaches the core. Every option is set to
// what is not its default; then every field of the message is set, and every option of the core is
// the caller's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <optional>

#include "client/messages/assess_request.h"
#include "client/messages/chart_request.h"
#include "client/support/all_set.h"
#include "server/messages/assess_request.h"
#include "server/messages/chart_request.h"
#include "wire/mapping/member_count.h"

namespace gonio::test {
namespace {

using wire::member_count;

TEST(RequestFields, OfAnAssessment) {
  const client::AssessLimits limits{1, 2, 3, 4, 0.5, 6, 7, 0.8, 9, 0.1, 0.11, 0.12, 0.13, 14, 15};
  static_assert(member_count<client::AssessLimits>() == 15, "set the new one above");
  const client::AssessOptions sent{.limits = limits,
                                   .pairs = 77,
                                   .seed = 9,
                                   .instruction_set = client::InstructionSet::baseline,
                                   .deadline = std::chrono::seconds(1)};  // not sent
  static_assert(member_count<client::AssessOptions>() == 5, "set the new one above");
  const auto request = client::assess_request(client::Material::model("lambertian"), sent);
  ASSERT_TRUE(request);
  expect_all_set(*request);
  const assess::Options got = server::assess_options(*request);
  EXPECT_EQ(got.pairs, sent.pairs);
  EXPECT_EQ(got.seed, sent.seed);
  static_assert(member_count<assess::Options>() == 3, "compare the new one above");
  const assess::Limits& l = got.limits;
  const std::array<std::optional<double>, 15> both{
      l.error,          l.reference_error, l.reciprocity, l.gain,      l.loss,
      l.mass,           l.weight_error,    l.probability, l.deviation, l.missing,
      l.missing_region, l.zeros,           l.holes,       l.outlier,   l.extreme};
  EXPECT_THAT(both,
              ::testing::ElementsAre(1, 2, 3, 4, 0.5, 6, 7, 0.8, 9, 0.1, 0.11, 0.12, 0.13, 14, 15));
  static_assert(member_count<assess::Limits>() == 15, "compare the new one above");
}

TEST(RequestFields, OfAChart) {
  const client::ChartOptions sent{.parts = {"fits"},
                                  .data = one_pair(),
                                  .repetitions = 3,
                                  .seconds = 0.01,
                                  .pairs_at_a_place = 77,
                                  .seed = 9,
                                  .deadline = std::chrono::seconds(1)};  // not sent
  static_assert(member_count<client::ChartOptions>() == 7, "set the new one above");
  const auto request = client::chart_request(sent);
  ASSERT_TRUE(request);
  expect_all_set(*request);
  EXPECT_EQ(request->pairs().values_size(), 3);
  const auto task = server::chart_task(*request, server::Materials());
  ASSERT_TRUE(task) << task.error().message;
  EXPECT_EQ(task->parts, sent.parts);
  EXPECT_EQ(task->pairs.values_size(), 3);
  EXPECT_EQ(task->options.effort.repetitions, static_cast<int>(sent.repetitions));
  EXPECT_EQ(task->options.effort.seconds, sent.seconds);
  // `clock` is the measurement's.
  static_assert(member_count<timing::Effort>() == 3, "compare the new one above");
  EXPECT_EQ(task->options.pairs, sent.pairs_at_a_place);
  EXPECT_EQ(task->options.seed, sent.seed);
  // `progress` and `stop` are the call's.
  static_assert(member_count<chart::Options>() == 5, "compare the new one above");
}

}  // namespace
}  // namespace gonio::test
