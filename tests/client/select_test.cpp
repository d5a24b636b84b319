// Selections through the client library, on every transport.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "client/support/fit_fixture.h"
#include "select/prices.h"

namespace gonio::test {
namespace {

using ::testing::HasSubstr;

// All candidates are tried in some of these: that takes a server that gives way long where other
// tests run beside.
class Select : public FitFixture {
 protected:
  void SetUp() override {
    start_with([](server::ServerOptions& server) { server.fits_give_way = false; });
  }
};

client::SelectScene scene_of(double tolerance) {
  client::SelectScene scene;
  scene.bins = {{{0, 1}, {0, 1.3}}};
  scene.tolerance = tolerance;
  scene.anisotropy = false;
  return scene;
}

client::SelectOptions quick() {
  client::SelectOptions options;
  options.whole_front = false;
  options.lobes = 1;
  options.starts = 1;
  options.fitted = options.validation = options.certification = 600;
  options.costs = gonio::testing::prices_of_all_parts();
  return options;
}

client::Material isotropic() {
  return client::Material::model(
      "ggx", {{"f0", std::vector{1.0, 0.71, 0.29}}, {"alpha_x", 0.2}, {"alpha_y", 0.2}});
}

TEST_F(Select, SaysTheSameOnEveryTransport) {
  std::string json;
  std::vector<double> errors;
  for (const char* transport : {"tcp", "unix", "in-process"}) {
    std::size_t messages = 0;
    client::SelectWatch watch;
    watch.progress = [&](const client::SelectProgress&) { ++messages; };
    const auto result = connect(transport).select(isotropic(), scene_of(0.1), quick(), watch);
    ASSERT_TRUE(result.ok()) << result.error().message;
    ASSERT_TRUE(result->choice) << result->reason;
    const client::SelectChoice& choice = *result->choice;
    const client::SelectEntry& entry = result->entries[choice.entry];
    EXPECT_THAT(entry.name, HasSubstr("ggx"));
    EXPECT_TRUE(entry.meets && entry.on_front);
    EXPECT_GT(entry.ns, 0);
    EXPECT_GT(entry.bytes, 0U);
    EXPECT_LT(choice.error.upper, 0.1);
    EXPECT_GE(choice.confidence, 0.95);
    // Some of what the sampler draws is outside the scene.
    EXPECT_GT(choice.pairs, 400U);
    EXPECT_LE(choice.pairs, 600U);
    ASSERT_TRUE(choice.material && entry.material);
    EXPECT_LE(choice.material->to_json().size(), entry.material->to_json().size());
    EXPECT_THAT(result->json, HasSubstr("\"reason\""));
    EXPECT_GE(messages, 1U);
    // What is chosen can be evaluated.
    EXPECT_TRUE(connect(transport).channels(*choice.material).ok());
    std::vector<double> now;
    for (const auto& one : result->entries) now.push_back(one.error.upper);
    if (!errors.empty()) {
      EXPECT_EQ(now, errors) << transport;
      EXPECT_EQ(result->json, json) << transport;
    }
    errors = now;
    json = result->json;
  }
}

TEST_F(Select, TakesMeasuredPairs) {
  const Measured measured(3000);
  const auto result = connect("unix").select(measured.data(), scene_of(0.3), quick());
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_TRUE(result->choice) << result->reason;
  for (const auto& entry : result->entries) EXPECT_TRUE(entry.material) << entry.name;
}

TEST_F(Select, TheReferenceItselfHasNoMaterial) {
  client::SelectOptions options = quick();
  options.costs["reference"] = 0.5;
  const auto result = connect("unix").select(isotropic(), scene_of(0.1), options);
  ASSERT_TRUE(result.ok()) << result.error().message;
  ASSERT_TRUE(result->choice);
  EXPECT_EQ(result->entries[result->choice->entry].name, "reference");
  EXPECT_FALSE(result->choice->material);
}

TEST_F(Select, NothingIsGoodEnough) {
  const Measured measured(600);  // with 5 % noise
  client::SelectOptions options = quick();
  options.fitted = options.validation = options.certification = 100;
  const auto result = connect("unix").select(measured.data(), scene_of(0.001), options);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_FALSE(result->choice);
  EXPECT_THAT(result->reason, HasSubstr("no candidate meets the tolerance of 0.001"));
}

TEST_F(Select, NamesWhatIsWrong) {
  const auto client = connect("tcp");
  const auto error_of = [&](const client::SelectReference& reference,
                            const client::SelectScene& scene,
                            const client::SelectOptions& options = quick()) {
    const auto result = client.select(reference, scene, options);
    EXPECT_FALSE(result.ok());
    return result ? Error() : result.error();
  };
  EXPECT_EQ(error_of(isotropic(), {}).field, "scene");
  EXPECT_EQ(error_of(isotropic(), scene_of(0)).field, "scene.tolerance");
  EXPECT_EQ(error_of(client::Material::named("brass"), scene_of(0.1)).code, ErrorCode::not_found);
  client::SelectOptions options = quick();
  options.seed = 0;
  EXPECT_EQ(error_of(isotropic(), scene_of(0.1), options).field, "options.seed");
  const std::vector<float> up{0, 0, 1}, nan{std::numeric_limits<float>::quiet_NaN()};
  const Error error = error_of(client::FitData{up, up, nan, 1, {}, std::nullopt}, scene_of(0.1));
  EXPECT_EQ(error.field, "reference");
  EXPECT_THAT(error.message, HasSubstr("0 usable pairs of 1 (1 not finite"));
}

TEST_F(Select, StopsWhenItIsTold) {
  client::SelectOptions options = quick();
  options.lobes = 2;
  options.fitted = 200'000;
  client::SelectWatch watch;
  bool heard = false;
  watch.progress = [&](const client::SelectProgress&) { heard = true; };
  watch.stop = [&] { return heard; };
  const auto result = connect("unix").select(isotropic(), scene_of(1e-9), options, watch);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::cancelled);
  EXPECT_THAT(result.error().message, HasSubstr("the selection was cancelled"));
}

}  // namespace
}  // namespace gonio::test
