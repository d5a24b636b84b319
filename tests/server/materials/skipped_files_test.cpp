// Files of a materials folder that cannot be used: they are skipped and named, and the others
// served.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "measured/synthetic_merl.h"
#include "server/support/harness.h"
#include "server/support/materials_folder.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::glossy_example;
using gonio::testing::TempFolder;
using gonio::testing::write_merl;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

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
