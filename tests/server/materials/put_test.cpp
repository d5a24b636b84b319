// PutMaterial: what arrives whole is stored and served.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "gonio/measured/table.h"
#include "server/support/put_client.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(Put, ServesWhatWasPut) {
  const auto response = stored("grey-1");
  EXPECT_EQ(response.name(), "grey-1");
  EXPECT_EQ(response.place(), v1::MATERIAL_PLACE_MEMORY);
  EXPECT_EQ(response.cells(), MeasuredTable::kCells);
  EXPECT_GT(response.invalid_cells(), 0U);
  EXPECT_FALSE(response.existed());
  EXPECT_THAT(names(), ElementsAre("grey-1"));
  const PairArrays pairs = random_pairs(100);
  auto request = request_for(pairs, 0, pairs.size());
  request.mutable_material()->set_name("grey-1");
  const auto evaluated = server_->evaluated(request);
  const auto table = MeasuredTable::parse_merl(content(), "x");
  ASSERT_TRUE(table.ok());
  const auto expected = core_values<float, float>(
      Material::from_table(*table, Interpolation::linear), pairs.wi, pairs.wo);
  EXPECT_EQ(std::vector<float>(evaluated.values().begin(), evaluated.values().end()), expected);
}

TEST_F(Put, TheSameAgainChangesNothingAndAnotherIsRefused) {
  stored("grey");
  EXPECT_TRUE(stored("grey").existed());
  std::string other = content();
  other[100] = static_cast<char>(other[100] ^ 1);
  const Error error = refused(announced("grey", other.size(), sum_of(other)), other);
  EXPECT_EQ(error.code, ErrorCode::already_exists);
  EXPECT_EQ(error.field, "file.name");
  EXPECT_THAT(error.value, HasSubstr("grey"));
}

TEST_F(Put, GoesIntoTheFolderAsAWhole) {
  const TempFolder folder;
  std::ofstream(folder / "gold.json") << R"({"model": "ggx"})";
  options_.materials = folder / "";
  start(options_);
  EXPECT_EQ(stored("grey").place(), v1::MATERIAL_PLACE_FOLDER);
  EXPECT_EQ(read_all(folder / "grey.binary"), content());
  EXPECT_EQ(refused(announced("gold", content().size(), sum_), "").code, ErrorCode::already_exists);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / ""))
    files.push_back(entry.path().filename());
  EXPECT_EQ(files.size(), 2U);  // nothing temporary
  start(options_);
  EXPECT_THAT(names(), ElementsAre("gold", "grey"));
}

TEST_F(Put, LeftoversGoUnlessALivingServerHasThem) {
  const TempFolder folder;
  for (const char* name : {".put-oldOLD", ".put-newNEW", ".put-a.json", "old.txt"})
    std::ofstream(folder / name) << R"({"model": "lambertian"})";
  std::filesystem::create_symlink(folder / "old.txt", folder / ".put-linked");
  const int living = ::open((folder / ".put-newNEW").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::flock(living, LOCK_EX), 0);
  options_.materials = folder / "";
  start(options_);
  EXPECT_FALSE(std::filesystem::exists(folder / ".put-oldOLD"));
  for (const char* other : {".put-newNEW", ".put-a.json", "old.txt", ".put-linked"})
    EXPECT_TRUE(std::filesystem::exists(folder / other)) << other;
  ::close(living);
  start(options_);
  EXPECT_FALSE(std::filesystem::exists(folder / ".put-newNEW"));
}

TEST_F(Put, AFileThatIsNotServedKeepsItsName) {
  const TempFolder folder;
  std::ofstream(folder / "grey.binary") << "broken";
  options_.materials = folder / "";
  start(options_);
  const Error error = refused({announced("grey", content().size(), sum_)});
  EXPECT_EQ(error.code, ErrorCode::already_exists);
  EXPECT_THAT(error.value, HasSubstr("cannot use"));
}

TEST_F(Put, DoesNotReplaceAFileThatCameMeanwhile) {
  const TempFolder folder;
  options_.materials = folder / "";
  start(options_);
  std::ofstream(folder / "grey.binary") << "another's";
  std::ofstream(folder / "gold.json") << "another's";
  for (const char* name : {"grey", "gold"}) {
    const Error error = refused(announced(name, content().size(), sum_), content());
    EXPECT_EQ(error.code, ErrorCode::already_exists) << name;
    EXPECT_THAT(error.value, HasSubstr("materials folder has a file"));
  }
  EXPECT_EQ(read_all(folder / "grey.binary"), "another's");
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Put, GoesIntoMemoryWhereTheFolderIsReadOnly) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "fixed");
  std::filesystem::permissions(
      folder / "fixed", std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  if (::access((folder / "fixed").c_str(), W_OK) == 0)
    GTEST_SKIP() << "this user may write to a read-only folder";
  options_.materials = folder / "fixed";
  start(options_);
  EXPECT_EQ(stored("grey").place(), v1::MATERIAL_PLACE_MEMORY);
}

}  // namespace
}  // namespace gonio::server::testing
