// PutMaterial: what arrives whole is stored and served, everything else leaves nothing behind.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "gonio/measured/table.h"
#include "measured/synthetic_merl.h"
#include "measured/temp_folder.h"
#include "server/support/harness.h"
#include "wire/sha256.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::Rgb;
using gonio::testing::TempFolder;
using gonio::testing::write_merl;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string read_all(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A MERL file's bytes.
const std::string& content() {
  static const std::string kContent = [] {
    const TempFolder folder;
    EXPECT_TRUE(write_merl(folder / "x.binary", [](double theta_h, double theta_d, double) {
      return Rgb{theta_h < 1 ? 0.5 : -1, 0.25, theta_d};
    }));
    return read_all(folder / "x.binary");
  }();
  return kContent;
}

std::string sum_of(std::string_view bytes) {
  const auto sum = wire::sha256(bytes);
  return {sum.begin(), sum.end()};
}

v1::PutMaterialRequest announced(const std::string& name, std::uint64_t size,
                                 const std::string& sum) {
  v1::PutMaterialRequest request;
  request.mutable_file()->set_name(name);
  request.mutable_file()->set_size(size);
  request.mutable_file()->set_sha256(sum);
  return request;
}

std::vector<v1::PutMaterialRequest> chunks_of(std::string_view bytes) {
  constexpr std::size_t kChunk = 1000003;  // does not divide anything
  std::vector<v1::PutMaterialRequest> chunks;
  for (std::size_t at = 0; at < bytes.size(); at += kChunk)
    chunks.emplace_back().set_chunk(std::string(bytes.substr(at, kChunk)));
  return chunks;
}

class Put : public ::testing::Test {
 protected:
  void SetUp() override { start(options_); }

  void start(const ServerOptions& options) {
    server_.reset();
    server_ = std::make_unique<TestServer>(options);
  }

  grpc::Status send(const std::vector<v1::PutMaterialRequest>& parts,
                    v1::PutMaterialResponse* response) {
    grpc::ClientContext context;
    const auto writer = server_->stub->PutMaterial(&context, response);
    for (const auto& part : parts) {
      if (!writer->Write(part)) break;
    }
    writer->WritesDone();
    return writer->Finish();
  }
  v1::PutMaterialResponse stored(const std::string& name, const std::string& bytes = content()) {
    auto parts = chunks_of(bytes);
    parts.insert(parts.begin(), announced(name, bytes.size(), sum_of(bytes)));
    v1::PutMaterialResponse response;
    const auto status = send(parts, &response);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return response;
  }
  Error refused(const std::vector<v1::PutMaterialRequest>& parts) {
    v1::PutMaterialResponse response;
    const auto status = send(parts, &response);
    EXPECT_FALSE(status.ok());
    EXPECT_FALSE(status.error_details().empty()) << status.error_message();
    return wire::from_status(status);
  }
  Error refused(const v1::PutMaterialRequest& first, std::string_view bytes) {
    auto parts = chunks_of(bytes);
    parts.insert(parts.begin(), first);
    return refused(parts);
  }
  std::vector<std::string> names() {
    grpc::ClientContext context;
    v1::ListModelsResponse listed;
    EXPECT_TRUE(server_->stub->ListModels(&context, {}, &listed).ok());
    return {listed.materials().begin(), listed.materials().end()};
  }

  const std::string sum_ = sum_of(content());
  ServerOptions options_;
  std::unique_ptr<TestServer> server_;
};

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

TEST_F(Put, BadNamesAreRefused) {
  for (const std::string& name :
       {std::string(), std::string("../grey"), std::string("a/b"), std::string("a\\b"),
        std::string("."), std::string(".."), std::string("grey.binary"), std::string("-\0-", 3),
        std::string("gr\xC3\xA4y"), std::string(101, 'x')}) {
    const Error error = refused({announced(name, content().size(), sum_)});
    EXPECT_EQ(error.code, ErrorCode::invalid_argument) << name;
    EXPECT_EQ(error.field, "file.name") << name;
    EXPECT_THAT(error.allowed, HasSubstr("1 to 100 letters")) << name;
  }
}

TEST_F(Put, WhatIsWrongIsNamed) {
  const std::size_t size = content().size();
  const auto good = announced("grey", size, sum_);
  EXPECT_EQ(refused(std::vector<v1::PutMaterialRequest>{}).field, "file");
  EXPECT_EQ(refused(chunks_of(content())).field, "file");
  EXPECT_EQ(refused({good, good}).value, "given twice");
  EXPECT_EQ(refused({v1::PutMaterialRequest()}).field, "part");
  EXPECT_EQ(refused({announced("grey", size, "short")}).field, "file.sha256");
  EXPECT_EQ(refused({announced("grey", size - 1, sum_)}).code, ErrorCode::data_loss);
  const Error large = refused({announced("grey", std::uint64_t{1} << 40, sum_)});
  EXPECT_EQ(large.code, ErrorCode::resource_exhausted);
  EXPECT_EQ(large.field, "file.size");
  EXPECT_THAT(large.allowed, HasSubstr(std::to_string(size)));
  const Error truncated = refused(good, std::string_view(content()).substr(0, size - 1));
  EXPECT_EQ(truncated.code, ErrorCode::data_loss);
  EXPECT_EQ(truncated.field, "chunk");
  EXPECT_THAT(truncated.value, HasSubstr(std::to_string(size - 1)));
  EXPECT_EQ(refused(good, content() + "x").field, "chunk");
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Put, DamagedBytesAndOtherFilesAreRefused) {
  std::string damaged = content();
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 4);
  const Error sum = refused(announced("grey", damaged.size(), sum_), damaged);
  EXPECT_EQ(sum.code, ErrorCode::data_loss);
  EXPECT_EQ(sum.field, "file.sha256");
  EXPECT_EQ(sum.value, wire::hexadecimal(wire::sha256(content())));
  EXPECT_THAT(sum.allowed, HasSubstr(wire::hexadecimal(wire::sha256(damaged))));
  const TempFolder folder;
  options_.materials = folder / "";
  start(options_);
  std::string other = content();
  other[0] = 89;
  const Error error = refused(announced("grey", other.size(), sum_of(other)), other);
  EXPECT_EQ(error.code, ErrorCode::data_loss);
  EXPECT_EQ(error.field, "chunk");
  EXPECT_THAT(error.message, HasSubstr("dimensions 89 90 180"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

TEST_F(Put, KeepsWithinTheQuota) {
  options_.put_quota_bytes = std::size_t{30} << 20;  // of one table, 17.5 MB
  start(options_);
  stored("first");
  const Error error = refused({announced("second", content().size(), sum_)});
  EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
  EXPECT_EQ(error.field, "file");
  EXPECT_THAT(error.allowed, HasSubstr(std::to_string(std::size_t{30} << 20)));
  options_.put_quota_bytes = 0;
  start(options_);
  EXPECT_EQ(refused({announced("first", content().size(), sum_)}).code,
            ErrorCode::resource_exhausted);
}

TEST_F(Put, KeepsWithinTheMemoryOfRequests) {
  options_.memory_quota_bytes = options_.max_message_bytes = std::size_t{16} << 20;
  start(options_);
  const auto first = announced("grey", content().size(), sum_);
  const Error error = refused(first, content());
  EXPECT_EQ(error.code, ErrorCode::resource_exhausted);
  EXPECT_THAT(error.message, HasSubstr("memory is full"));
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Put, ACancelledUploadLeavesNothing) {
  const TempFolder folder;
  options_.materials = folder / "";
  start(options_);
  {
    grpc::ClientContext context;
    v1::PutMaterialResponse response;
    const auto writer = server_->stub->PutMaterial(&context, &response);
    writer->Write(announced("grey", content().size(), sum_));
    for (const auto& chunk : chunks_of(std::string_view(content()).substr(0, 5'000'000)))
      writer->Write(chunk);
    context.TryCancel();
    EXPECT_EQ(writer->Finish().error_code(), grpc::StatusCode::CANCELLED);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
  EXPECT_EQ(stored("grey").place(), v1::MATERIAL_PLACE_FOLDER);
}

}  // namespace
}  // namespace gonio::server::testing
