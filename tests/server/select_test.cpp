// Select: the core's own selection over the wire, what is refused, what is cancelled.
#include "select/select.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <limits>

#include "effort.h"
#include "fit/synthetic.h"
#include "select/prices.h"
#include "server/messages/select_messages.h"
#include "server/support/progress_client.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::data_of;
using gonio::testing::kSlower;
using gonio::testing::prices_of_all_parts;
using gonio::testing::scattered_pairs;
using gonio::testing::WorkClock;
using namespace std::chrono_literals;
using ::testing::HasSubstr;

// Few pairs, and only isotropic candidates of one lobe.
v1::SelectRequest quick_selection(double tolerance = 0.1) {
  v1::SelectRequest request;
  set_ggx(*request.mutable_material());
  v1::SelectBin& bin = *request.mutable_scene()->add_bins();
  bin.mutable_theta_i()->set_upper(1);
  bin.mutable_theta_o()->set_upper(1.3);
  request.mutable_scene()->set_tolerance(tolerance);
  request.mutable_scene()->set_isotropic(true);
  v1::SelectOptions& options = *request.mutable_options();
  options.set_up_to_the_choice(true);
  options.set_lobes(1);
  options.set_starts(1);
  options.set_fitted(500);
  options.set_validation(600);
  options.set_certification(700);
  for (const auto& [part, ns] : prices_of_all_parts()) (*options.mutable_costs())[part] = ns;
  return request;
}

// Other tests may run beside.
ServerOptions not_giving_way() {
  ServerOptions options;
  options.fits_give_way = false;
  return options;
}

select::Options core_options() {
  select::Options options;
  options.whole_front = false;
  options.lobes = 1;
  options.starts = 1;
  options.sizes = {500, 600, 700};
  options.costs = prices_of_all_parts();
  return options;
}

select::Scene core_scene() {
  select::Scene scene;
  scene.bins = {{{0, 1}, {0, 1.3}}};
  scene.tolerance = 0.1;
  scene.anisotropy = false;
  return scene;
}

TEST(SelectCall, IsTheCoresOwnSelection) {
  TestServer server(not_giving_way());
  const auto answer = ask(server, quick_selection());
  ASSERT_TRUE(answer.status.ok()) << answer.status.error_message();
  ASSERT_TRUE(answer.result);
  EXPECT_TRUE(answer.result->has_choice());
  EXPECT_GE(answer.stages.count("queued") + answer.stages.count("reference"), 1U);
  const auto own = select::choose(core_ggx(), core_scene(), core_options());
  ASSERT_TRUE(own.ok()) << own.error().message;
  EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(*answer.result, to_wire(*own)));
}

TEST(SelectCall, TakesMeasuredPairs) {
  TestServer server(not_giving_way());
  v1::SelectRequest request = quick_selection();
  const MaterialSpec grey{LobeSpec{"lambertian", {{"rd", std::vector{0.5}}}}, {}, {}};
  const fit::Data data = data_of(grey, scattered_pairs(3000, 1), 0.01);
  v1::MeasuredPairs& pairs = *request.mutable_pairs();
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.add_wi(data.wi[k][i]);
      pairs.add_wo(data.wo[k][i]);
    }
    pairs.add_values(data.values[i]);
  }
  pairs.set_channels(1);
  const auto answer = ask(server, request);
  ASSERT_TRUE(answer.status.ok()) << answer.status.error_message();
  ASSERT_TRUE(answer.result && answer.result->has_choice());
  EXPECT_EQ(answer.result->entries(static_cast<int>(answer.result->choice().entry())).name(),
            "lambertian");
  pairs.set_channels(0);
  EXPECT_EQ(refused(server, request).field, "pairs.channels");
  pairs.set_channels(1);
  pairs.add_values(1);
  EXPECT_EQ(refused(server, request).field, "pairs.values");
  pairs.mutable_values()->RemoveLast();
  for (float& value : *pairs.mutable_values()) value = std::numeric_limits<float>::quiet_NaN();
  const Error error = refused(server, request);
  EXPECT_EQ(error.field, "reference");
  EXPECT_THAT(error.value, HasSubstr("3000 not finite"));
}

TEST(SelectCall, SaysWhatIsWrong) {
  TestServer server(not_giving_way());
  const auto with = [&](const auto& change) {
    v1::SelectRequest request = quick_selection();
    change(request);
    return refused(server, request).field;
  };
  EXPECT_EQ(with([](auto& r) { r.mutable_scene()->clear_bins(); }), "scene");
  EXPECT_EQ(with([](auto& r) { r.mutable_scene()->set_tolerance(0); }), "scene.tolerance");
  EXPECT_EQ(with([](auto& r) { r.mutable_scene()->set_confidence(0); }), "scene.confidence");
  EXPECT_EQ(with([](auto& r) { r.mutable_scene()->set_metric(v1::SelectMetric(9)); }),
            "scene.metric");
  EXPECT_EQ(with([](auto& r) { r.mutable_scene()->set_cost(v1::SelectCost(-1)); }), "scene.cost");
  EXPECT_EQ(with([](auto& r) { r.mutable_scene()->set_lights(v1::SelectLights(3)); }),
            "scene.lights");
  EXPECT_EQ(
      with([](auto& r) { r.mutable_scene()->mutable_bins(0)->mutable_theta_o()->set_lower(1.4); }),
      "scene.theta_o");
  EXPECT_EQ(with([](auto& r) { r.mutable_options()->set_lobes(4'000'000'000U); }), "options.lobes");
  EXPECT_EQ(with([](auto& r) { r.mutable_options()->set_fitted(1); }), "options.sizes.fitted");
  EXPECT_EQ(with([](auto& r) { (*r.mutable_options()->mutable_costs())["ward"] = -1; }),
            "options.costs.ward");
  EXPECT_EQ(with([](auto& r) { r.clear_reference(); }), "reference");
  EXPECT_EQ(with([](auto& r) { r.mutable_material()->set_model("nothing"); }), "material.model");
}

// A selection that would take long: all candidates, on many pairs.
v1::SelectRequest long_selection() {
  v1::SelectRequest request = quick_selection(1e-9);
  request.mutable_scene()->set_isotropic(false);
  request.mutable_options()->set_fitted(200'000);
  request.mutable_options()->set_starts(20);
  return request;
}

TEST(SelectCall, EndsSoonWhenItIsCancelled) {
  ServerOptions options = not_giving_way();
  options.fit_threads = 1;
  TestServer server(options);
  EXPECT_EQ(ask(server, long_selection(), true).status.error_code(), grpc::StatusCode::CANCELLED);
  // The only thread is soon free for the next.
  const auto begin = WorkClock::now();
  EXPECT_TRUE(ask(server, quick_selection(0.9)).status.ok());
  EXPECT_LT(WorkClock::now() - begin, kSlower * 2s);
}

TEST(SelectCall, KeepsTheServersOwnDeadline) {
  ServerOptions options = not_giving_way();
  options.longest_fit = 200ms;
  TestServer server(options);
  const auto begin = WorkClock::now();
  const auto answer = ask(server, long_selection());
  EXPECT_EQ(answer.status.error_code(), grpc::StatusCode::DEADLINE_EXCEEDED);
  EXPECT_THAT(answer.status.error_message(), HasSubstr("the selection was not done"));
  EXPECT_LT(WorkClock::now() - begin, kSlower * 2s);
}

}  // namespace
}  // namespace gonio::server::testing
