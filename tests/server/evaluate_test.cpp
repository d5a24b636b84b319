// Evaluate: right values in every form of request, and what comes with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gonio/engine/grid.h"
#include "server/support/harness.h"

namespace gonio::server::testing {
namespace {

using ::testing::ElementsAreArray;

TEST(Evaluate, PairsInFloat) {
  TestServer server;
  const PairArrays pairs = random_pairs(5000);
  const auto response = server.evaluated(ggx_request(pairs));
  EXPECT_EQ(response.channels(), 3U);
  EXPECT_TRUE(response.flags().empty());
  EXPECT_EQ(response.values_f64_size(), 0);
  EXPECT_THAT(response.values(),
              ElementsAreArray(core_values<float, float>(core_ggx(), pairs.wi, pairs.wo)));
}

TEST(Evaluate, PairsInFloatWithReferencePrecision) {
  TestServer server;
  const PairArrays pairs = random_pairs(5000);
  v1::EvaluateRequest request = ggx_request(pairs);
  request.set_precision(v1::PRECISION_REFERENCE);
  const auto response = server.evaluated(request);
  EXPECT_EQ(response.values_size(), 0);
  EXPECT_THAT(response.values_f64(),
              ElementsAreArray(core_values<float, double>(core_ggx(), pairs.wi, pairs.wo)));
}

TEST(Evaluate, PairsInDouble) {
  TestServer server;
  const PairArrays pairs = random_pairs(5000);
  const std::vector<double> wi(pairs.wi.begin(), pairs.wi.end()),
      wo(pairs.wo.begin(), pairs.wo.end());
  v1::EvaluateRequest request;
  set_ggx(*request.mutable_material());
  request.set_precision(v1::PRECISION_REFERENCE);
  request.mutable_pairs_f64()->mutable_wi()->Add(wi.begin(), wi.end());
  request.mutable_pairs_f64()->mutable_wo()->Add(wo.begin(), wo.end());
  EXPECT_THAT(server.evaluated(request).values_f64(),
              ElementsAreArray(core_values<double, double>(core_ggx(), wi, wo)));
}

v1::EvaluateRequest grid_request() {
  v1::EvaluateRequest request;
  set_ggx(*request.mutable_material());
  for (int i = 0; i < 9; ++i) {
    request.mutable_grid()->add_theta_i(0.15 * i);
    request.mutable_grid()->add_phi_i(0.7 * i);
    request.mutable_grid()->add_theta_o(0.16 * i);
    request.mutable_grid()->add_phi_o(0.5 * i);
  }
  return request;
}

TEST(Evaluate, GridIsExpandedInTheDocumentedNesting) {
  TestServer server;
  v1::EvaluateRequest request = grid_request();
  const auto& axes = request.grid();
  PairArrays pairs;
  const auto add = [](std::vector<float>& to, double theta, double phi) {
    to.push_back(static_cast<float>(std::sin(theta) * std::cos(phi)));
    to.push_back(static_cast<float>(std::sin(theta) * std::sin(phi)));
    to.push_back(static_cast<float>(std::cos(theta)));
  };
  for (double ti : axes.theta_i()) {
    for (double pi : axes.phi_i()) {
      for (double to : axes.theta_o()) {
        for (double po : axes.phi_o()) {
          add(pairs.wi, ti, pi);
          add(pairs.wo, to, po);
        }
      }
    }
  }
  EXPECT_THAT(server.evaluated(request).values(),
              ElementsAreArray(core_values<float, float>(core_ggx(), pairs.wi, pairs.wo)));
}

TEST(Evaluate, ARunOfAGridIsAPartOfTheWhole) {
  TestServer server;
  v1::EvaluateRequest request = grid_request();
  request.set_precision(v1::PRECISION_REFERENCE);
  const auto whole = server.evaluated(request);
  ASSERT_EQ(whole.values_f64_size(), 3 * 9 * 9 * 9 * 9);
  request.mutable_grid()->set_first(4321);
  const auto rest = server.evaluated(request);
  request.mutable_grid()->set_count(7);
  const auto seven = server.evaluated(request);
  EXPECT_EQ(rest.values_f64_size(), whole.values_f64_size() - 3 * 4321);
  ASSERT_EQ(seven.values_f64_size(), 21);
  for (int i = 0; i < 21; ++i) {
    EXPECT_EQ(seven.values_f64(i), whole.values_f64(3 * 4321 + i));
    EXPECT_EQ(rest.values_f64(i), whole.values_f64(3 * 4321 + i));
  }
}

TEST(Evaluate, HalfAngleGrid) {
  TestServer server;
  v1::EvaluateRequest request;
  set_ggx(*request.mutable_material());
  const std::vector<double> theta_h = {0, 0.2, 0.4}, theta_d = {0.1, 0.5}, phi_d = {0, 1, 2, 3};
  request.mutable_grid()->mutable_theta_h()->Add(theta_h.begin(), theta_h.end());
  request.mutable_grid()->mutable_theta_d()->Add(theta_d.begin(), theta_d.end());
  request.mutable_grid()->mutable_phi_d()->Add(phi_d.begin(), phi_d.end());
  const auto grid = Grid::half_angle(theta_h, theta_d, phi_d);
  std::vector<float> wi(72), wo(72);
  grid->expand(0, 24, wi.data(), wo.data());
  EXPECT_THAT(server.evaluated(request).values(),
              ElementsAreArray(core_values<float, float>(core_ggx(), wi, wo)));
}

TEST(Evaluate, BadPairsAreFlaggedAndTouchNothingElse) {
  TestServer server;
  PairArrays pairs = random_pairs(6000);
  const auto clean = server.evaluated(ggx_request(pairs));
  pairs.wi[3 * 10] = std::nanf("");
  for (int c = 0; c < 3; ++c) pairs.wo[3 * 20 + static_cast<std::size_t>(c)] = 0;
  pairs.wi[3 * 5999 + 2] = -pairs.wi[3 * 5999 + 2];
  const auto response = server.evaluated(ggx_request(pairs));
  ASSERT_EQ(response.flags().size(), 6000U);
  for (std::size_t i = 0; i < 6000; ++i) {
    const bool bad = i == 10 || i == 20 || i == 5999;
    EXPECT_EQ(response.flags()[i] != 0, bad) << i;
    for (std::size_t c = 0; c < 3; ++c) {
      const int at = static_cast<int>(3 * i + c);
      EXPECT_EQ(response.values(at), bad ? 0 : clean.values(at));
    }
  }
  EXPECT_EQ(response.flags()[10], flag::not_finite);
  EXPECT_EQ(response.flags()[20], flag::zero);
  EXPECT_EQ(response.flags()[5999], flag::incident_below_horizon);
}

TEST(Evaluate, EmptyBatchHasNoValues) {
  TestServer server;
  v1::EvaluateRequest request;
  set_ggx(*request.mutable_material());
  request.mutable_pairs();
  const auto response = server.evaluated(request);
  EXPECT_EQ(response.channels(), 3U);
  EXPECT_EQ(response.values_size(), 0);
}

TEST(Evaluate, ReportSaysWhatItCostAndWhatItIsWorth) {
  TestServer server;
  v1::EvaluateRequest request = ggx_request(random_pairs(20'000));
  for (Isa isa : supported_isas()) {
    request.set_instruction_set(isa == Isa::baseline ? v1::INSTRUCTION_SET_BASELINE
                                : isa == Isa::avx2   ? v1::INSTRUCTION_SET_AVX2
                                                     : v1::INSTRUCTION_SET_AVX512);
    const auto report = server.evaluated(request).report();
    EXPECT_EQ(report.instruction_set(), request.instruction_set());
    EXPECT_EQ(report.precision(), v1::PRECISION_FAST);
    EXPECT_GT(report.kernel_seconds(), 0);
    EXPECT_EQ(report.error_bound().relative(), core_ggx().error_bound(Precision::fast).relative);
  }
  request.clear_instruction_set();
  const auto report = server.evaluated(request).report();
  EXPECT_NE(report.instruction_set(), v1::INSTRUCTION_SET_UNSPECIFIED);
}

TEST(Evaluate, InstructionSetIsTheOneAskedFor) {
  TestServer server;
  const PairArrays pairs = random_pairs(3000);
  v1::EvaluateRequest request = ggx_request(pairs);
  request.set_instruction_set(v1::INSTRUCTION_SET_BASELINE);
  EXPECT_THAT(
      server.evaluated(request).values(),
      ElementsAreArray(core_values<float, float>(core_ggx(), pairs.wi, pairs.wo, Isa::baseline)));
}

}  // namespace
}  // namespace gonio::server::testing
