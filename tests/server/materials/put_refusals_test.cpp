// PutMaterial: what is not a whole good file, or more than there is room for, leaves nothing
// behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "server/support/put_client.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

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
