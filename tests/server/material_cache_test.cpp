#include "server/materials/material_cache.h"

#include <gtest/gtest.h>

#include "server/support/harness.h"

namespace gonio::server::testing {
namespace {

TEST(MaterialCache, FindsWhatWasKept) {
  MaterialCache cache;
  EXPECT_FALSE(cache.find("a"));
  const Material gold = core_ggx();
  cache.keep("a", gold);
  ASSERT_TRUE(cache.find("a"));
  EXPECT_EQ(&cache.find("a")->material().impl(), &gold.impl());
  EXPECT_FALSE(cache.find("b"));
}

TEST(MaterialCache, ForgetsTheUnusedAndKeepsTheUsed) {
  MaterialCache cache;
  cache.keep("used", core_ggx());
  cache.keep("unused", core_ggx());
  for (int i = 0; i < 2000; ++i) {
    cache.keep(std::to_string(i), core_ggx());
    EXPECT_TRUE(cache.find("used"));
  }
  EXPECT_FALSE(cache.find("unused"));
  EXPECT_FALSE(cache.find("0"));
  EXPECT_TRUE(cache.find("1999"));
}

TEST(MaterialCache, DoesNotKeepWhatIsLarge) {
  MaterialCache cache;
  const std::string large(5000, 'x');
  cache.keep(large, core_ggx());
  EXPECT_FALSE(cache.find(large));
}

// It is made once, whichever copy is asked first.
TEST(MaterialCache, KeepsTheSamplerWithTheMaterial) {
  MaterialCache cache;
  cache.keep("a", core_ggx());
  const PreparedMaterial first = *cache.find("a");
  EXPECT_FALSE(first.has_sampler());
  const std::size_t bytes = first.bytes();
  const Sampler& sampler = first.sampler();
  const PreparedMaterial again = *cache.find("a");
  EXPECT_TRUE(again.has_sampler());
  EXPECT_EQ(&again.sampler(), &sampler);
  EXPECT_EQ(again.bytes(), bytes + sampler.bytes());
}

TEST(MaterialCache, ErrorsAreNotRemembered) {
  TestServer server;
  v1::EvaluateRequest request = ggx_request(random_pairs(1));
  set_ggx(*request.mutable_material(), 7);
  for (int i = 0; i < 3; ++i) EXPECT_NE(server.refused(request).field, "");
  set_ggx(*request.mutable_material(), 0.5);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(server.evaluated(request).values_size(), 3);
}

}  // namespace
}  // namespace gonio::server::testing
