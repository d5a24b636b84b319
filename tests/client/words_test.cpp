// Names that people write, the wire's words and the core's are the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <string>

#include "gonio/client/fit.h"
#include "gonio/client/select.h"
#include "gonio/v1/fit.pb.h"
#include "gonio/v1/select.pb.h"

namespace gonio::test {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

TEST(SelectWords, NearMissesAreRefused) {
  for (const char* name :
       {"L1", "l1 ", " l1", "l2", "l", "", "rms", "logarithm", "Cbrt", "delta"}) {
    const auto found = client::metric_of(name);
    ASSERT_FALSE(found.ok()) << name;
    EXPECT_EQ(found.error().field, "scene.metric");
    EXPECT_EQ(found.error().value, '"' + std::string(name) + '"');
    EXPECT_THAT(found.error().allowed, StartsWith("l1, rmse, log, cbrt, delta_e"));
  }
  EXPECT_THAT(client::metric_of("Cbrt").error().allowed, EndsWith("; did you mean \"cbrt\"?"));
  EXPECT_EQ(client::metric_of("").error().allowed, "l1, rmse, log, cbrt, delta_e");
  EXPECT_EQ(client::cost_of("NS").error().allowed, "ns, bytes, ns_variance; did you mean \"ns\"?");
  EXPECT_EQ(client::lights_of("sun").error().allowed, "directional, environment");
  EXPECT_EQ(*client::metric_of("cbrt"), client::SelectMetric::cbrt);
  EXPECT_EQ(*client::metric_of("delta_e"), client::SelectMetric::delta_e);
  EXPECT_EQ(*client::cost_of("ns_variance"), client::SelectCost::ns_variance);
  EXPECT_EQ(*client::lights_of("environment"), client::SelectLights::environment);
}

// The wire's words, without what they begin with, are the names, in the order of the enums.
template <class Find>
void expect_named(const google::protobuf::EnumDescriptor& words, const std::string& prefix,
                  const Find& find) {
  const auto number_of = [&](const std::string& name) {
    const auto found = find(name);
    return found ? static_cast<int>(*found) + 1 : 0;
  };
  EXPECT_EQ(number_of("unspecified"), 0);
  for (int i = 1; i < words.value_count(); ++i) {
    std::string name = words.value(i)->name().substr(prefix.size());
    for (char& c : name) c = static_cast<char>(std::tolower(c));
    EXPECT_EQ(number_of(name), words.value(i)->number()) << name;
  }
}

TEST(SelectWords, AreThoseOfTheWire) {
  expect_named(*gonio::v1::SelectMetric_descriptor(), "SELECT_METRIC_", client::metric_of);
  expect_named(*gonio::v1::SelectCost_descriptor(), "SELECT_COST_", client::cost_of);
  expect_named(*gonio::v1::SelectLights_descriptor(), "SELECT_LIGHTS_", client::lights_of);
}

// What the client calls an objective the core calls so, too.
TEST(FitWords, AreThoseOfTheWireAndOfTheCore) {
  const auto& words = *gonio::v1::FitObjective_descriptor();
  EXPECT_EQ(words.value_count() - 1, fit::kObjectiveCount);
  for (int i = 0; i < fit::kObjectiveCount; ++i) {
    const std::string name(fit::name_of(static_cast<fit::Objective>(i)));
    ASSERT_TRUE(client::objective_of(name)) << name;
    EXPECT_EQ(client::name_of(*client::objective_of(name)), name);
  }
  expect_named(words, "FIT_OBJECTIVE_", client::objective_of);
}

}  // namespace
}  // namespace gonio::test
