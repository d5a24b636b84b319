// What a server says that it offers: its models, its materials, and those that it cannot use.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "client/support/server_fixture.h"
#include "gonio/client/client.h"

namespace gonio::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class ListModelsTest : public ServerFixture {};

TEST_F(ListModelsTest, ListsWhatTheServerDoesNotServe) {
  const gonio::testing::TempFolder folder;
  std::ofstream(folder / "gold.json") << R"({"model": "ggx"})";
  std::ofstream(folder / "rough.json") << R"({"model": "ggx", "parameters": {"alpha_x": 7}})";
  server::ServerOptions options;
  options.materials = folder / "";
  const auto server = server::Server::start(options);
  ASSERT_TRUE(server.ok());
  const auto client = client::Client::from_channel((*server)->in_process_channel(), "it");
  const auto catalogue = client->list_models();
  ASSERT_TRUE(catalogue.ok());
  EXPECT_THAT(catalogue->materials, ::testing::ElementsAre("gold"));
  ASSERT_EQ(catalogue->skipped_materials.size(), 1U);
  EXPECT_EQ(catalogue->skipped_materials[0].name, "rough");
  EXPECT_THAT(catalogue->skipped_materials[0].reason,
              ::testing::AllOf(HasSubstr("rough.json"), HasSubstr("alpha_x is 7")));
}

TEST_F(ListModelsTest, ListsModels) {
  auto catalogue = connect("tcp").list_models();
  ASSERT_TRUE(catalogue.ok()) << catalogue.error().message;
  std::vector<std::string> names;
  for (const auto& model : catalogue->models) names.push_back(model.name);
  EXPECT_THAT(names,
              ::testing::IsSupersetOf({"lambertian", "ashikhmin_shirley", "cook_torrance", "ggx"}));
  EXPECT_FALSE(catalogue->server_version.empty());
  EXPECT_THAT(catalogue->instruction_sets, Contains(client::InstructionSet::baseline));

  auto one = connect("tcp").list_models("ggx");
  ASSERT_TRUE(one.ok());
  ASSERT_EQ(one->models.size(), 1U);
  const auto& parameters = one->models[0].parameters;
  const auto alpha = std::find_if(parameters.begin(), parameters.end(),
                                  [](const auto& p) { return p.name == "alpha_x"; });
  ASSERT_NE(alpha, parameters.end());
  EXPECT_EQ(alpha->upper, 1.0);
  EXPECT_FALSE(alpha->meaning.empty());
  EXPECT_TRUE(alpha->presets.empty());
  const auto eta = std::find_if(parameters.begin(), parameters.end(),
                                [](const auto& p) { return p.name == "eta"; });
  ASSERT_NE(eta, parameters.end());
  ASSERT_FALSE(eta->presets.empty());
  EXPECT_EQ(eta->presets[0].name, "gold");
  EXPECT_EQ(eta->presets[0].values, (std::vector{0.14, 0.43, 1.38}));
  EXPECT_THAT(eta->presets[0].source, HasSubstr("1972"));
  EXPECT_EQ(eta->preset_partner, "k");

  auto none = connect("tcp").list_models("gggx");
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error().code, ErrorCode::not_found);
  EXPECT_THAT(none.error().message, HasSubstr("gggx"));
}

}  // namespace
}  // namespace gonio::test
