// A substance's name where a material's is expected.
#include "server/materials/preset_material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "measured/temp_folder.h"
#include "server/materials/materials.h"

namespace gonio::server {
namespace {

using gonio::testing::TempFolder;
using ::testing::HasSubstr;

std::string named(const std::string& name) {
  v1::Material material;
  material.set_name(name);
  return material.SerializeAsString();
}

TEST(PresetMaterial, EverySubstanceIsAMaterialOfThreeChannels) {
  const Materials materials;
  const auto names = preset_names();
  EXPECT_GE(names.size(), 10U);
  for (const std::string& name : names) {
    const auto material = materials.resolve(named(name));
    ASSERT_TRUE(material.ok()) << material.error().message;
    EXPECT_EQ(material->material().channels(), 3) << name;
  }
  EXPECT_EQ(preset_material("copper")->parameters().fields().count("eta"), 1U);
  EXPECT_EQ(preset_material("copper")->parameters().fields().count("f0"), 0U);
  EXPECT_EQ(preset_material("water")->parameters().fields().count("f0"), 1U);
  EXPECT_FALSE(preset_material("Copper").has_value());
}

TEST(PresetMaterial, AStoredMaterialOfThatNameWins) {
  const TempFolder folder;
  std::ofstream(folder / "copper.json") << R"({"model": "lambertian", "parameters": {"rd": 0.5}})";
  const auto materials = Materials::load(folder / "");
  ASSERT_TRUE(materials.ok());
  EXPECT_EQ(materials->resolve(named("copper"))->material().channels(), 1);
  EXPECT_EQ(materials->resolve(named("gold"))->material().channels(), 3);
}

TEST(PresetMaterial, AWrongNameIsAnsweredWithTheNearest) {
  const Materials materials;
  const auto coper = materials.resolve(named("coper"));
  ASSERT_FALSE(coper.ok());
  EXPECT_THAT(coper.error().message, HasSubstr("did you mean \"copper\"?"));
  EXPECT_THAT(materials.resolve(named("ggx")).error().message, HasSubstr(R"({"model": "ggx"})"));
}

}  // namespace
}  // namespace gonio::server
