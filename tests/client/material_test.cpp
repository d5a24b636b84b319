// Materials as the client holds them: their forms, and what is none.
#include "gonio/client/material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gonio::test {
namespace {

using client::Material;
using ::testing::HasSubstr;

TEST(Material, JsonErrors) {
  EXPECT_FALSE(Material::from_json("{").ok());
  EXPECT_FALSE(Material::from_json("[]").ok());
  auto unknown = Material::from_json(R"({"modell": "ggx"})");
  ASSERT_FALSE(unknown.ok());
  EXPECT_THAT(unknown.error().message, HasSubstr("modell"));
}

TEST(Material, AllFormsAgree) {
  const auto built = Material::sum(client::Lobe{"lambertian", {{"rd", std::vector{0.2, 0.3}}}},
                                   {{"cook_torrance", {{"m", 0.3}, {"fresnel", "dielectric"}}}});
  const auto read = Material::from_json(built.to_json());
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->wire(), built.wire());
  const auto written = Material::from_json(
      R"({"diffuse": {"model": "lambertian", "parameters": {"rd": [0.2, 0.3]}},
          "specular": [{"model": "cook_torrance", "parameters": {"m": 0.3, "fresnel": "dielectric"}}]})");
  ASSERT_TRUE(written.ok());
  EXPECT_EQ(written->wire(), built.wire());
  EXPECT_EQ(Material::named("gold").to_json(), R"({"name":"gold"})");
}

TEST(Material, ItsRotationGoesThroughJson) {
  const Material gold = Material::named("gold").rotated(30);
  EXPECT_EQ(gold.to_json(), R"({"name":"gold","rotation":30})");
  EXPECT_EQ(Material::from_json(gold.to_json())->wire(), gold.wire());
  const auto written =
      Material::from_json(R"({"model": "ggx", "parameters": {}, "rotation": -12.5})");
  ASSERT_TRUE(written.ok()) << written.error().message;
  EXPECT_EQ(written->wire(), Material::model("ggx").rotated(-12.5).wire());
  // A given 0 is not the same as none: a fit holds it.
  EXPECT_EQ(Material::model("ggx").rotated(0).to_json(),
            R"({"model":"ggx","parameters":{},"rotation":0})");
  const auto word = Material::from_json(R"({"model": "ggx", "rotation": "left"})");
  ASSERT_FALSE(word.ok());
  EXPECT_THAT(word.error().message, HasSubstr("rotation"));
}

// Maps of a message come in any order; what is written, cached and compared does not.
TEST(Material, IsTheSameTextAndBytesAlways) {
  const client::Parameters many{
      {"alpha_x", 0.1}, {"alpha_y", 0.2}, {"eta", 1.5}, {"f0", 0.3}, {"scale", 2.0}};
  const Material first = Material::model("ggx", many);
  EXPECT_EQ(first.to_json(), R"({"model":"ggx","parameters":)"
                             R"({"alpha_x":0.1,"alpha_y":0.2,"eta":1.5,"f0":0.3,"scale":2}})");
  for (int i = 0; i < 20; ++i) {
    const Material again = Material::from_json(first.to_json()).value();
    EXPECT_EQ(again.to_json(), first.to_json());
    EXPECT_EQ(again.wire(), first.wire());
  }
}

}  // namespace
}  // namespace gonio::test
