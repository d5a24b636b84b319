#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "gonio/base/version.h"
#include "gonio/engine/registry.h"
#include "server/support/harness.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

TEST(ListModels, SaysWhatTheRegistrySays) {
  TestServer server;
  grpc::ClientContext context;
  v1::ListModelsResponse response;
  ASSERT_TRUE(server.stub->ListModels(&context, {}, &response).ok());
  ASSERT_EQ(static_cast<std::size_t>(response.models_size()), models().size());
  for (int m = 0; m < response.models_size(); ++m) {
    const v1::Model& found = response.models(m);
    const ModelDescription& expected = models()[static_cast<std::size_t>(m)];
    EXPECT_EQ(found.name(), expected.name);
    EXPECT_EQ(found.fast().relative(), expected.fast.relative);
    EXPECT_EQ(found.reference().note(), expected.reference.note);
    EXPECT_NE(found.role(), v1::MODEL_ROLE_UNSPECIFIED);
    ASSERT_EQ(static_cast<std::size_t>(found.parameters_size()), expected.parameters.size());
    for (int p = 0; p < found.parameters_size(); ++p) {
      const Parameter& parameter = expected.parameters[static_cast<std::size_t>(p)];
      EXPECT_EQ(found.parameters(p).name(), parameter.name);
      EXPECT_EQ(found.parameters(p).upper(), parameter.upper);
      EXPECT_EQ(static_cast<std::size_t>(found.parameters(p).words_size()), parameter.words.size());
    }
  }
  EXPECT_EQ(static_cast<std::size_t>(response.instruction_sets_size()), supported_isas().size());
  EXPECT_EQ(response.version(), kVersion);
  EXPECT_EQ(response.materials_size(), 0);
}

TEST(ListModels, CarriesThePresets) {
  TestServer server;
  grpc::ClientContext context;
  v1::ListModelsResponse response;
  ASSERT_TRUE(server.stub->ListModels(&context, {}, &response).ok());
  int total = 0;
  for (int m = 0; m < response.models_size(); ++m) {
    const ModelDescription& model = models()[static_cast<std::size_t>(m)];
    for (int p = 0; p < response.models(m).parameters_size(); ++p) {
      const v1::Parameter& found = response.models(m).parameters(p);
      const Parameter& expected = model.parameters[static_cast<std::size_t>(p)];
      EXPECT_EQ(found.preset_partner(), expected.preset_partner);
      ASSERT_EQ(static_cast<std::size_t>(found.presets_size()), expected.presets.size());
      for (int i = 0; i < found.presets_size(); ++i, ++total) {
        const Preset& preset = expected.presets[static_cast<std::size_t>(i)];
        EXPECT_EQ(found.presets(i).name(), preset.name);
        EXPECT_EQ(found.presets(i).source(), preset.source);
        EXPECT_TRUE(std::equal(preset.rgb.begin(), preset.rgb.end(),
                               found.presets(i).values().begin(), found.presets(i).values().end()));
      }
    }
  }
  EXPECT_GT(total, 0);
}

TEST(ListModels, OneByName) {
  TestServer server;
  grpc::ClientContext context;
  v1::ListModelsRequest request;
  request.set_name("ggx");
  v1::ListModelsResponse response;
  ASSERT_TRUE(server.stub->ListModels(&context, request, &response).ok());
  ASSERT_EQ(response.models_size(), 1);
  EXPECT_EQ(response.models(0).name(), "ggx");
}

TEST(ListModels, AnUnknownNameIsNotFound) {
  TestServer server;
  grpc::ClientContext context;
  v1::ListModelsRequest request;
  request.set_name("gxg");
  v1::ListModelsResponse response;
  const grpc::Status status = server.stub->ListModels(&context, request, &response);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_THAT(status.error_message(), HasSubstr("ggx"));
}

}  // namespace
}  // namespace gonio::server::testing
