// Assessments through the client library, on every transport.
#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include "client/support/server_fixture.h"
#include "wire/mapping/assessment.h"

namespace gonio::test {
namespace {

using ::testing::HasSubstr;
using Assess = ServerFixture;

client::AssessOptions quick() {
  client::AssessOptions options;
  options.pairs = 200;
  return options;
}

// What the service answered, as the JSON has it, is what the caller has.
void expect_all_there(const client::Assessment& result) {
  v1::AssessResponse answer;
  ASSERT_TRUE(google::protobuf::util::JsonStringToMessage(result.json, &answer).ok());
  answer.clear_instruction_set();  // beside the rest, see below
  const auto had = wire::to_message<assess::Assessment>(result);
  EXPECT_TRUE(google::protobuf::util::MessageDifferencer::Equals(had, answer));
}

TEST_F(Assess, SaysTheSameOnEveryTransport) {
  std::vector<double> values;
  for (const char* transport : {"tcp", "unix", "in-process"}) {
    const auto result = connect(transport).assess(ggx(), quick());
    ASSERT_TRUE(result.ok()) << result.error().message;
    EXPECT_TRUE(result->passed);
    EXPECT_EQ(result->channels, 3);
    EXPECT_EQ(result->checks.size(), 11U);
    EXPECT_GE(result->places.size(), 17U);
    EXPECT_EQ(result->incidences.size(), 17U);  // anisotropic: along v, too
    EXPECT_EQ(result->incidences[0].albedo.size(), 3U);
    EXPECT_EQ(result->fast.relative, 3e-6);
    ASSERT_TRUE(result->places[0].naive32);
    EXPECT_GT(result->places[0].naive32->worst.error, result->places[0].fast.worst.error);
    EXPECT_NE(result->instruction_set, client::InstructionSet::best);
    EXPECT_GT(result->cpu_seconds, 0);
    EXPECT_THAT(result->json, HasSubstr("\"near_mirror\""));
    expect_all_there(*result);
    std::vector<double> now;
    for (const auto& check : result->checks) now.push_back(check.value);
    if (!values.empty()) {
      EXPECT_EQ(now, values) << transport;
    }
    values = now;
  }
}

TEST_F(Assess, LimitsTravel) {
  client::AssessOptions options = quick();
  options.limits.error = 1e-9;
  options.instruction_set = client::InstructionSet::baseline;
  const auto result = connect("unix").assess(ggx(), options);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_FALSE(result->passed);
  EXPECT_EQ(result->instruction_set, client::InstructionSet::baseline);
  for (const auto& check : result->checks) {
    EXPECT_EQ(check.passed, check.name != "error_fast") << check.name;
    EXPECT_EQ(check.limit == 1e-9, check.name == "error_fast") << check.name;
  }
}

TEST_F(Assess, NamesWhatIsWrong) {
  const auto client = connect("tcp");
  const auto error_of = [&](const client::Material& material,
                            const client::AssessOptions& options) {
    const auto result = client.assess(material, options);
    EXPECT_FALSE(result.ok());
    return result ? Error() : result.error();
  };
  client::AssessOptions options = quick();
  options.limits.probability = 2;
  EXPECT_EQ(error_of(ggx(), options).field, "limits.probability");
  options = quick();
  options.pairs = 0;
  EXPECT_EQ(error_of(ggx(), options).field, "pairs");
  options = quick();
  options.seed = 0;
  EXPECT_EQ(error_of(ggx(), options).field, "seed");
  EXPECT_EQ(error_of(client::Material::named("brass"), quick()).code, ErrorCode::not_found);
}

TEST_F(Assess, KeepsItsDeadline) {
  client::AssessOptions options;
  options.pairs = 1'000'000;
  options.deadline = std::chrono::milliseconds(100);
  const auto begin = std::chrono::steady_clock::now();
  const auto result = connect("tcp").assess(ggx(), options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::deadline_exceeded) << result.error().message;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
}

}  // namespace
}  // namespace gonio::test
