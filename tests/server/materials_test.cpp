// A materials folder: what is served, and what is said of files that cannot be.
#include "server/materials/materials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gonio/measured/table.h"
#include "measured/synthetic_merl.h"
#include "measured/temp_folder.h"
#include "server/support/harness.h"
#include "wire/convert.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::glossy_example;
using gonio::testing::Rgb;
using gonio::testing::TempFolder;
using gonio::testing::write_merl;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;
using ::testing::Not;

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

ServerOptions serving(const TempFolder& folder) {
  ServerOptions options;
  options.materials = folder / "";
  return options;
}

v1::ListModelsResponse listed_by(TestServer& server) {
  grpc::ClientContext context;
  v1::ListModelsResponse listed;
  EXPECT_TRUE(server.stub->ListModels(&context, {}, &listed).ok());
  return listed;
}

// What a check says of a folder of which nothing but "good" can be served. A server starts with it,
// serves that, and says the same.
std::string refusal(const TempFolder& folder) {
  write(folder / "good.json", R"({"model": "lambertian"})");
  const auto checked = Server::check(serving(folder));
  EXPECT_FALSE(checked.ok());
  if (checked) return "";
  TestServer server(serving(folder));
  const auto listed = listed_by(server);
  EXPECT_THAT(listed.materials(), ElementsAre("good"));
  EXPECT_GT(listed.skipped_materials_size(), 0);
  for (const auto& skipped : listed.skipped_materials()) {
    EXPECT_THAT(checked.error().message, HasSubstr(skipped.reason()));
    EXPECT_THAT(skipped.reason(), Not(HasSubstr((folder / "").string())));
    v1::EvaluateRequest request = request_for(random_pairs(1), 0, 1);
    request.mutable_material()->set_name(skipped.name());
    const Error error = server.refused(request);
    EXPECT_EQ(error.code, ErrorCode::not_found);
    EXPECT_EQ(error.field, "material.name");
    EXPECT_THAT(error.message, AllOf(HasSubstr(skipped.name()), HasSubstr("cannot use")));
  }
  return checked.error().message;
}

std::vector<float> values_of(TestServer& server, const std::string& name, const PairArrays& pairs) {
  v1::EvaluateRequest request = request_for(pairs, 0, pairs.size());
  request.mutable_material()->set_name(name);
  const auto response = server.evaluated(request);
  return {response.values().begin(), response.values().end()};
}

TEST(Materials, AreServedUnderTheirFilesNames) {
  const TempFolder folder;
  write(
      folder / "gold.json",
      R"({"model": "ggx", "parameters": {"f0": [1, 0.71, 0.29], "alpha_x": 0.2, "alpha_y": 0.2}})");
  write(folder / "paint.json",
        R"({"diffuse": {"model": "lambertian"}, "specular": [{"model": "cook_torrance"}]})");
  write(folder / "README.txt", "not a material");
  TestServer server(serving(folder));
  grpc::ClientContext context;
  v1::ListModelsResponse listed;
  ASSERT_TRUE(server.stub->ListModels(&context, {}, &listed).ok());
  EXPECT_THAT(listed.materials(), ElementsAre("gold", "paint"));
  const PairArrays pairs = random_pairs(100);
  EXPECT_THAT(values_of(server, "gold", pairs),
              ElementsAreArray(core_values<float, float>(core_ggx(), pairs.wi, pairs.wo)));
}

// What a request adds to a stored material's own rotation, for tables too; f of a turned material
// is that of the unturned one for directions turned back.
TEST(Materials, AStoredOneIsTurnedFurther) {
  const TempFolder folder;
  constexpr const char* kBrushed =
      R"("model": "ggx", "parameters": {"alpha_x": 0.1, "alpha_y": 0.5})";
  write(folder / "brushed.json", "{" + std::string(kBrushed) + R"(, "rotation": 50})");
  ASSERT_TRUE(write_merl(folder / "chrome.binary", glossy_example));
  TestServer server(serving(folder));
  const PairArrays pairs = random_pairs(100);
  const auto values = [&](const std::string& json) {
    v1::EvaluateRequest request = request_for(pairs, 0, pairs.size());
    *request.mutable_material() = *wire::material_from_json(json);
    const auto response = server.evaluated(request);
    return std::vector<float>(response.values().begin(), response.values().end());
  };
  const auto by_70 = values("{" + std::string(kBrushed) + R"(, "rotation": 70})");
  EXPECT_THAT(values(R"({"name": "brushed", "rotation": 20})"), ElementsAreArray(by_70));
  EXPECT_THAT(values(R"({"name": "brushed", "rotation": 0})"),
              ElementsAreArray(values(R"({"name": "brushed"})")));
  EXPECT_NE(by_70, values(R"({"name": "brushed"})"));
  EXPECT_THAT(values(R"({"name": "chrome", "rotation": 20})"),
              ElementsAreArray(values(R"({"name": "chrome"})")));
  v1::EvaluateRequest request = request_for(pairs, 0, pairs.size());
  *request.mutable_material() = *wire::material_from_json(R"({"name": "chrome", "rotation": 200})");
  EXPECT_EQ(server.refused(request).field, "material.rotation");
}

TEST(Materials, AMisspeltNameGetsSuggestions) {
  const TempFolder folder;
  write(folder / "gold.json", R"({"model": "ggx"})");
  TestServer server(serving(folder));
  v1::EvaluateRequest request = request_for(random_pairs(1), 0, 1);
  request.mutable_material()->set_name("glod");
  const Error error = server.refused(request);
  EXPECT_EQ(error.code, ErrorCode::not_found);
  EXPECT_EQ(error.field, "material.name");
  EXPECT_THAT(error.allowed, HasSubstr("gold"));
}

TEST(Materials, MeasuredFilesByNameAndThroughJson) {
  const TempFolder folder;
  ASSERT_TRUE(write_merl(folder / "glossy.binary", glossy_example));
  write(
      folder / "cells.json",
      R"({"model": "measured", "parameters": {"file": "glossy.binary", "interpolation": "nearest"}})");
  write(folder / "smooth.json",
        R"({"model": "measured", "parameters": {"file": "glossy.binary"}})");
  TestServer server(serving(folder));
  const PairArrays pairs = random_pairs(2000);
  const auto table = MeasuredTable::read_merl(folder / "glossy.binary");
  ASSERT_TRUE(table.ok());
  const auto linear = Material::from_table(*table, Interpolation::linear);
  const auto nearest = Material::from_table(*table, Interpolation::nearest);
  const auto linear_values = core_values<float, float>(linear, pairs.wi, pairs.wo);
  const auto nearest_values = core_values<float, float>(nearest, pairs.wi, pairs.wo);
  EXPECT_NE(linear_values, nearest_values);
  EXPECT_EQ(values_of(server, "glossy", pairs), linear_values);
  EXPECT_EQ(values_of(server, "smooth", pairs), linear_values);
  EXPECT_EQ(values_of(server, "cells", pairs), nearest_values);
}

TEST(Materials, LocalFilesOnlyWhereAllowed) {
  const TempFolder folder;
  ASSERT_TRUE(write_merl(folder / "glossy.binary", glossy_example));
  v1::EvaluateRequest request = request_for(random_pairs(10), 0, 10);
  request.mutable_material()->set_model("measured");
  auto& fields = *request.mutable_material()->mutable_parameters()->mutable_fields();
  fields["file"].set_string_value((folder / "glossy.binary").string());
  fields["interpolation"].set_string_value("nearest");
  TestServer remote;
  EXPECT_EQ(remote.refused(request).field, "material.model");
  ServerOptions options;
  options.allow_local_files = true;
  TestServer embedded(options);
  EXPECT_EQ(embedded.evaluated(request).values_size(), 30);
  fields["interpolation"].set_string_value("cubic");
  EXPECT_EQ(embedded.refused(request).field, "material.parameters.interpolation");
  fields.erase("interpolation");
  fields["files"].set_string_value("x");
  EXPECT_EQ(embedded.refused(request).field, "material.parameters.files");
  fields.erase("files");
  fields["file"].set_number_value(3);
  EXPECT_EQ(embedded.refused(request).field, "material.parameters.file");
  fields.clear();
  EXPECT_EQ(embedded.refused(request).value, "not given");
  fields["file"].set_string_value("/no/such.binary");
  EXPECT_EQ(embedded.refused(request).code, ErrorCode::not_found);
}

TEST(Materials, ALocalFileIsReadAgainWhenItHasChanged) {
  const TempFolder folder;
  const auto constant = [](double f) {
    return [f](double, double, double) { return Rgb{f, f, f}; };
  };
  const auto file = folder / "constant.binary";
  ServerOptions options;
  options.allow_local_files = true;
  TestServer embedded(options);
  v1::EvaluateRequest request = request_for({{0, 0, 1}, {0, 0, 1}}, 0, 1);
  request.mutable_material()->set_model("measured");
  auto& fields = *request.mutable_material()->mutable_parameters()->mutable_fields();
  fields["file"].set_string_value(file.string());
  ASSERT_TRUE(write_merl(file, constant(0.1)));
  const auto first = std::filesystem::last_write_time(file);
  for (int i = 0; i < 2; ++i) EXPECT_FLOAT_EQ(embedded.evaluated(request).values(0), 0.1F);
  ASSERT_TRUE(write_merl(file, constant(0.2)));
  std::filesystem::last_write_time(file, first + std::chrono::seconds(1));
  EXPECT_FLOAT_EQ(embedded.evaluated(request).values(0), 0.2F);
  std::filesystem::remove(file);
  EXPECT_EQ(embedded.refused(request).code, ErrorCode::not_found);
}

TEST(Materials, BadFilesAreSkippedAndNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"{", "JSON"},
      {"", "empty"},
      {R"({"modle": "ggx"})", "modle"},
      {R"({"model": "gxg"})", "gxg"},
      {R"({"model": "ggx", "parameters": {"alpha_x": 7}})", "parameters.alpha_x"},
      {R"({"name": "other"})", "name"},
      {R"({})", "material is empty"},
      {R"({"model": "measured", "parameters": {"file": "missing.binary"}})", "missing.binary"},
      {R"({"model": "measured", "parameters": {"file": "../outside.binary"}})",
       "within the materials folder"},
      {R"({"model": "measured", "parameters": {"file": "/etc/passwd"}})",
       "within the materials folder"},
      {R"({"model": "measured"})", "parameters.file"},
      {"\xFF\xFE{\0", "bad.json"},
  };
  for (const auto& [json, what] : cases) {
    const TempFolder folder;
    write(folder / "bad.json", json);
    EXPECT_THAT(refusal(folder), AllOf(HasSubstr("bad.json"), HasSubstr(what))) << json;
  }
}

TEST(Materials, AFileNameThatNoFileCanHaveIsAClearError) {
  const TempFolder folder;
  write(folder / "bad.json",
        R"({"model": "measured", "parameters": {"file": ")" + std::string(300, 'x') + R"("}})");
  EXPECT_THAT(refusal(folder), AllOf(HasSubstr("bad.json"), HasSubstr("xxx")));
}

TEST(Materials, ASymlinkDoesNotLeadOut) {
  const TempFolder outside, folder;
  ASSERT_TRUE(write_merl(outside / "secret.binary", glossy_example));
  std::filesystem::create_directory_symlink(outside / "", folder / "link");
  write(folder / "bad.json",
        R"({"model": "measured", "parameters": {"file": "link/secret.binary"}})");
  EXPECT_THAT(refusal(folder), HasSubstr("within the materials folder"));
}

TEST(Materials, ATruncatedMerlFileIsNamed) {
  const TempFolder folder;
  ASSERT_TRUE(write_merl(folder / "short.binary", glossy_example));
  std::filesystem::resize_file(folder / "short.binary", 1000);
  EXPECT_THAT(refusal(folder), HasSubstr("short.binary"));
}

TEST(Materials, OfTwoFilesOfOneNameNeitherIsServed) {
  const TempFolder folder;
  write(folder / "gold.json", R"({"model": "ggx"})");
  write(folder / "gold.binary", "x");
  EXPECT_THAT(refusal(folder), AllOf(HasSubstr("gold.json"), HasSubstr("another file")));
}

TEST(Materials, OddDirectoryEntriesAreNamed) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "folder.json");
  EXPECT_THAT(refusal(folder), HasSubstr("folder.json"));
  const TempFolder other;
  write(other / "caf\xE9.json", R"({"model": "ggx"})");
  EXPECT_THAT(refusal(other), HasSubstr("UTF-8"));
}

TEST(Materials, AFolderWithoutAFaultIsFoundGood) {
  const TempFolder folder;
  write(folder / "gold.json", R"({"model": "ggx"})");
  EXPECT_TRUE(Server::check(serving(folder)).ok());
}

TEST(Materials, AMissingFolderIsNamed) {
  ServerOptions options;
  options.materials = "/no/such/folder";
  const auto server = Server::start(options);
  ASSERT_FALSE(server.ok());
  EXPECT_THAT(server.error().message, HasSubstr("/no/such/folder"));
}

}  // namespace
}  // namespace gonio::server::testing
