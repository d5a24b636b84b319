// What is wrong with the directions or the choices of a request is said by field, value and what is
// allowed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "server/support/harness.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

struct BadRequest {
  const char* name;
  std::function<void(v1::EvaluateRequest&)> spoil;  // of a good request with two pairs
  const char* field;
  const char* value;
  const char* allowed;
};

v1::Grid& small_grid(v1::EvaluateRequest& request) {
  v1::Grid& grid = *request.mutable_grid();
  for (double angle : {0.1, 0.2}) {
    grid.add_theta_h(angle);
    grid.add_theta_d(angle);
    grid.add_phi_d(angle);
  }
  return grid;
}

const BadRequest kBadRequests[] = {
    {"NoDirections", [](auto& r) { r.clear_directions(); }, "directions", "not given",
     "pairs, pairs_f64 or grid"},
    {"BrokenWi", [](auto& r) { r.mutable_pairs()->add_wi(1); }, "pairs.wi", "7", "multiple of 3"},
    {"BrokenWo", [](auto& r) { r.mutable_pairs()->mutable_wo()->RemoveLast(); }, "pairs.wo", "5",
     "multiple of 3"},
    {"Unequal", [](auto& r) { r.mutable_pairs()->mutable_wo()->Truncate(3); }, "pairs.wo", "3",
     "6"},
    {"OnlyWi", [](auto& r) { r.mutable_pairs()->clear_wo(); }, "pairs.wo", "0", "6"},
    {"UnequalDoubles",
     [](auto& r) {
       r.set_precision(v1::PRECISION_REFERENCE);
       for (int i = 0; i < 3; ++i) r.mutable_pairs_f64()->add_wi(1);
     },
     "pairs_f64.wo", "0", "3"},
    {"DoublesForFast", [](auto& r) { r.mutable_pairs_f64(); }, "precision", "PRECISION_FAST",
     "PRECISION_REFERENCE"},
    {"UnknownPrecision", [](auto& r) { r.set_precision(static_cast<v1::Precision>(9)); },
     "precision", "9", "PRECISION_FAST (1)"},
    {"UnknownInstructionSet",
     [](auto& r) { r.set_instruction_set(static_cast<v1::InstructionSet>(77)); }, "instruction_set",
     "77", "INSTRUCTION_SET_AVX512 (3)"},
    {"GridWithoutAxes", [](auto& r) { r.mutable_grid(); }, "grid", "without axes", "theta_h"},
    {"GridOfBothKinds", [](auto& r) { small_grid(r).add_theta_i(0); }, "grid", "both kinds",
     "either"},
    {"GridWithAMissingAxis", [](auto& r) { small_grid(r).clear_theta_d(); }, "grid.theta_d",
     "empty", "at least one"},
    {"GridAngleNotFinite", [](auto& r) { small_grid(r).add_phi_d(INFINITY); }, "grid.phi_d[2]",
     "inf", "finite"},
    {"GridFirstBeyond", [](auto& r) { small_grid(r).set_first(8); }, "grid.first", "8", "below 8"},
    {"GridCountBeyond",
     [](auto& r) {
       small_grid(r).set_first(3);
       r.mutable_grid()->set_count(UINT64_MAX);
     },
     "grid.count", "18446744073709551615", "at most 5"},
};

class Directions : public ::testing::TestWithParam<BadRequest> {};

TEST_P(Directions, AreRefusedByName) {
  TestServer server;
  v1::EvaluateRequest request = ggx_request(random_pairs(2));
  GetParam().spoil(request);
  const Error error = server.refused(request);
  EXPECT_EQ(error.code, ErrorCode::invalid_argument);
  EXPECT_EQ(error.field, GetParam().field);
  EXPECT_THAT(error.value, HasSubstr(GetParam().value));
  EXPECT_THAT(error.allowed, HasSubstr(GetParam().allowed));
  EXPECT_THAT(error.message, HasSubstr(GetParam().field));
}

INSTANTIATE_TEST_SUITE_P(Bad, Directions, ::testing::ValuesIn(kBadRequests),
                         [](const auto& bad) { return std::string(bad.param.name); });

TEST(InstructionSet, OneThatTheProcessorLacksIsRefused) {
  if (is_supported(Isa::avx512)) GTEST_SKIP() << "this processor has every instruction set";
  TestServer server;
  v1::EvaluateRequest request = ggx_request(random_pairs(2));
  request.set_instruction_set(v1::INSTRUCTION_SET_AVX512);
  const Error error = server.refused(request);
  EXPECT_EQ(error.field, "instruction_set");
  EXPECT_THAT(error.allowed, HasSubstr("baseline"));
}

}  // namespace
}  // namespace gonio::server::testing
