#include "wire/convert.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include "gonio/base/shown.h"
#include "wire/status.h"

namespace gonio::wire {
namespace {

using ::testing::HasSubstr;

TEST(Convert, EnumsThereAndBack) {
  for (Precision precision : {Precision::fast, Precision::reference}) {
    EXPECT_EQ(from_wire(to_wire(precision)).value(), precision);
  }
  for (Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
    EXPECT_EQ(from_wire(to_wire(isa)).value(), isa);
  EXPECT_EQ(from_wire(v1::PRECISION_UNSPECIFIED).value(), Precision::fast);
}

TEST(Convert, UnknownEnumValuesAreNamed) {
  const auto precision = from_wire(static_cast<v1::Precision>(7));
  ASSERT_FALSE(precision.ok());
  EXPECT_EQ(precision.error().field, "precision");
  EXPECT_EQ(precision.error().value, "7");
  const auto isa = from_wire(static_cast<v1::InstructionSet>(-1));
  ASSERT_FALSE(isa.ok());
  EXPECT_EQ(isa.error().field, "instruction_set");
  EXPECT_EQ(isa.error().value, "-1");
}

TEST(Convert, MaterialJson) {
  const auto material = material_from_json(
      R"({"model": "ggx", "parameters": {"f0": [1, 0.71, 0.29], "alpha_x": 0.2}})");
  ASSERT_TRUE(material.ok());
  EXPECT_EQ(material->model(), "ggx");
  EXPECT_EQ(material->parameters().fields().at("f0").list_value().values_size(), 3);
}

TEST(Convert, BadMaterialJsonSaysWhat) {
  for (const char* json :
       {"", "{", "[1]", R"({"model": "ggx"} x)", R"({"model": 3})", "null garbage"}) {
    const auto material = material_from_json(json);
    ASSERT_FALSE(material.ok()) << json;
    EXPECT_EQ(material.error().code, ErrorCode::invalid_argument);
  }
  const auto misspelt = material_from_json(R"({"modle": "ggx"})");
  ASSERT_FALSE(misspelt.ok());
  EXPECT_THAT(misspelt.error().message, HasSubstr("modle"));
}

TEST(Status, EveryCodeComesBackWithItsDetail) {
  for (ErrorCode code :
       {ErrorCode::invalid_argument, ErrorCode::not_found, ErrorCode::data_loss,
        ErrorCode::resource_exhausted, ErrorCode::cancelled, ErrorCode::deadline_exceeded,
        ErrorCode::unavailable, ErrorCode::internal}) {
    const Error error = bad_value("a.b", "7", "at most 6", code);
    const Error back = from_status(to_status(error));
    EXPECT_EQ(back.code, code);
    EXPECT_EQ(back.message, "a.b is 7; allowed: at most 6");
    EXPECT_EQ(back.field, "a.b");
    EXPECT_EQ(back.value, "7");
    EXPECT_EQ(back.allowed, "at most 6");
  }
}

TEST(Status, ForeignStatusKeepsCodeAndMessage) {
  const Error error = from_status({grpc::StatusCode::UNAVAILABLE, "no route", "not a detail"});
  EXPECT_EQ(error.code, ErrorCode::unavailable);
  EXPECT_EQ(error.message, "no route");
}

TEST(Status, LongTextsFitIntoHeaders) {
  const std::string huge(1'000'000, 'x');
  const grpc::Status status = to_status(bad_value(huge, huge, huge));
  EXPECT_LT(3 * status.error_message().size() + 4 * status.error_details().size() / 3, 6000U);
}

// Protobuf refuses strings that are not UTF-8; a terminal obeys what they may hold.
TEST(Status, TextsAreUtf8OnOneLineGoingAndComing) {
  const std::string foreign("a\xFF\0\n\x1b[2J\xED\xA0\x80", 11);
  const Error error{ErrorCode::data_loss, foreign, foreign, foreign, foreign};
  const auto detail = to_detail(error);
  gonio::v1::ErrorDetail parsed;
  ASSERT_TRUE(parsed.ParseFromString(detail.SerializeAsString()));
  EXPECT_EQ(parsed.message(), shown(foreign));
  EXPECT_EQ(from_status(to_status(error)).value, shown(foreign));
  EXPECT_EQ(from_status({grpc::StatusCode::INTERNAL, foreign}).message, shown(foreign));
  gonio::v1::ErrorDetail sent;
  sent.set_message("\x1b[2J");
  EXPECT_EQ(from_detail(sent).message, "\\x1b[2J");
}

TEST(Status, ShorteningKeepsCharactersWhole) {
  EXPECT_EQ(shortened("short", 5), "short");
  EXPECT_EQ(shortened("longer", 5), "lo...");
  EXPECT_EQ(shortened("a\xC3\xA9\xC3\xA9\xC3\xA9", 5), "a...");
  EXPECT_EQ(shortened("longer", 2), "...");
}

}  // namespace
}  // namespace gonio::wire
