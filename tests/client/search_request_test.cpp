// Requests for fits and selections: what a caller sets reaches the core. Every option is set to
// what is not its default; then every field of the message is set, and every option of the core is
// the caller's.
#include <gtest/gtest.h>

#include <chrono>

#include "client/messages/fit_convert.h"
#include "client/messages/select_convert.h"
#include "client/support/all_set.h"
#include "server/materials/materials.h"
#include "server/messages/fit_request.h"
#include "server/messages/select_request.h"
#include "wire/mapping/member_count.h"

namespace gonio::test {
namespace {

using wire::member_count;

TEST(RequestFields, OfAFit) {
  const client::FitOptions sent{.objective = client::Objective::huber,
                                .strategy = client::FitStrategy::staged,
                                .anisotropic = true,
                                .cosine = false,
                                .huber = 0.3,
                                .min_theta = 0.1,
                                .max_theta = 1.2,
                                .starts = 7,
                                .fit_pairs = 300,
                                .scan_pairs = 200,
                                .polish = true,
                                .seed = 9,
                                .deadline = std::chrono::seconds(1)};  // not sent: the call's own
  static_assert(member_count<client::FitOptions>() == 13, "set the new one above");
  const auto request = client::fit_request(one_pair(), client::Material::model("lambertian"), sent);
  ASSERT_TRUE(request);
  expect_all_set(*request);
  const auto task = server::fit_task(*request, server::Materials());
  ASSERT_TRUE(task) << task.error().message;
  const fit::Options& got = task->options;
  EXPECT_EQ(got.objective, sent.objective);
  EXPECT_EQ(got.strategy, fit::Strategy::staged);
  EXPECT_EQ(got.anisotropic, sent.anisotropic);
  EXPECT_EQ(got.cosine, sent.cosine);
  EXPECT_EQ(got.huber, sent.huber);
  EXPECT_EQ(got.min_theta, sent.min_theta);
  EXPECT_EQ(got.max_theta, sent.max_theta);
  EXPECT_EQ(got.starts, sent.starts);
  EXPECT_EQ(got.fit_pairs, sent.fit_pairs);
  EXPECT_EQ(got.scan_pairs, sent.scan_pairs);
  EXPECT_EQ(got.polish, sent.polish);
  EXPECT_EQ(got.seed, sent.seed);
  // `hints` is not the caller's: a selection's own fits go without.
  static_assert(member_count<fit::Options>() == 13, "compare the new one above");
}

void expect_same(const select::Range& got, const client::SelectRange& sent) {
  EXPECT_EQ(got.lower, sent.lower);
  EXPECT_EQ(got.upper, sent.upper);
}

client::SelectScene some_scene() {
  const client::SelectBin bin{
      .theta_i = {0.1, 0.2}, .theta_o = {0.3, 0.4}, .phi = {0.5, 0.6}, .weight = 0.7};
  static_assert(member_count<client::SelectBin>() == 4, "set the new one above");
  static_assert(member_count<client::SelectScene>() == 7, "set the new one below");
  return {.bins = {bin},
          .lights = client::SelectLights::environment,
          .anisotropy = false,
          .metric = client::SelectMetric::cbrt,
          .tolerance = 0.02,
          .confidence = 0.9,
          .cost = client::SelectCost::ns_variance};
}

void expect_same(const select::Scene& got, const client::SelectScene& sent) {
  ASSERT_EQ(got.bins.size(), 1U);
  expect_same(got.bins[0].theta_i, sent.bins[0].theta_i);
  expect_same(got.bins[0].theta_o, sent.bins[0].theta_o);
  expect_same(got.bins[0].phi, sent.bins[0].phi);
  EXPECT_EQ(got.bins[0].weight, sent.bins[0].weight);
  static_assert(member_count<select::Bin>() == 4, "compare the new one above");
  EXPECT_EQ(got.lights, select::Lights::environment);
  EXPECT_EQ(got.anisotropy, sent.anisotropy);
  EXPECT_EQ(got.metric, select::Metric::cbrt);
  EXPECT_EQ(got.tolerance, sent.tolerance);
  EXPECT_EQ(got.confidence, sent.confidence);
  EXPECT_EQ(got.cost, select::CostKind::ns_variance);
  static_assert(member_count<select::Scene>() == 7, "compare the new one above");
}

void expect_same(const select::Options& got, const client::SelectOptions& sent) {
  EXPECT_EQ(got.whole_front, sent.whole_front);
  EXPECT_EQ(got.lobes, static_cast<int>(sent.lobes));
  EXPECT_EQ(got.costs, sent.costs);
  EXPECT_EQ(got.sizes.fitted, sent.fitted);
  EXPECT_EQ(got.sizes.validation, sent.validation);
  EXPECT_EQ(got.sizes.certification, sent.certification);
  static_assert(member_count<select::SetSizes>() == 3, "compare the new one above");
  EXPECT_EQ(got.starts, sent.starts);
  EXPECT_EQ(got.seed, sent.seed);
  // `progress` and `stop` are the call's.
  static_assert(member_count<select::Options>() == 8, "compare the new one above");
}

TEST(RequestFields, OfASelection) {
  const client::SelectOptions options{.whole_front = false,
                                      .lobes = 1,
                                      .costs = {{"lambertian", 2.5}},
                                      .fitted = 200,
                                      .validation = 300,
                                      .certification = 400,
                                      .starts = 5,
                                      .seed = 9,
                                      .deadline = std::chrono::seconds(1)};  // not sent
  static_assert(member_count<client::SelectOptions>() == 9, "set the new one above");
  const client::SelectScene scene = some_scene();
  const auto request =
      client::select_request(client::Material::model("lambertian"), scene, options);
  ASSERT_TRUE(request);
  expect_all_set(*request);
  const auto task = server::select_task(*request, server::Materials());
  ASSERT_TRUE(task) << task.error().message;
  expect_same(task->scene, scene);
  expect_same(task->options, options);
}

}  // namespace
}  // namespace gonio::test
