// Any legal protobuf is read, whatever its shape, and read as the generated parser reads it.
#include <gmock/gmock.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include "gonio/v1/service.pb.h"
#include "wire/codec.h"
#include "wire/fields.h"
#include "wire/message.h"
#include "wire/messages.h"

namespace gonio::wire::testing {
namespace {

using google::protobuf::util::MessageDifferencer;
using ::testing::ElementsAre;

// `bytes` decoded by the codec, put back into a message, against the generated parser's message.
void expect_same_as_generated(const std::string& bytes, std::size_t slice) {
  v1::EvaluateRequest expected;
  const bool legal = expected.ParseFromString(bytes);
  const auto decoded = decode<Request>(buffer_of(bytes, slice));
  ASSERT_EQ(decoded.ok(), legal);
  if (!legal) return;
  v1::EvaluateRequest rebuilt = decoded->head;
  if (decoded->material) {
    ASSERT_TRUE(rebuilt.mutable_material()->ParseFromString(*decoded->material));
  }
  if (decoded->kind == Request::Kind::pairs) {
    const auto wi = elements<float>(decoded->bytes, decoded->wi),
               wo = elements<float>(decoded->bytes, decoded->wo);
    rebuilt.mutable_pairs()->mutable_wi()->Add(wi.begin(), wi.end());
    rebuilt.mutable_pairs()->mutable_wo()->Add(wo.begin(), wo.end());
  } else if (decoded->kind == Request::Kind::pairs_f64) {
    const auto wi = elements<double>(decoded->bytes, decoded->wi),
               wo = elements<double>(decoded->bytes, decoded->wo);
    rebuilt.mutable_pairs_f64()->mutable_wi()->Add(wi.begin(), wi.end());
    rebuilt.mutable_pairs_f64()->mutable_wo()->Add(wo.begin(), wo.end());
  }
  EXPECT_EQ(decoded->kind == Request::Kind::none, expected.directions_case() == 0);
  expected.DiscardUnknownFields();
  rebuilt.DiscardUnknownFields();
  EXPECT_TRUE(MessageDifferencer::Equals(rebuilt, expected));
}

void put_float(std::string& out, std::uint32_t number, float value) {
  put_tag(out, number, WireType::fixed32);
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void put_bytes(std::string& out, std::uint32_t number, const std::string& content) {
  put_header(out, number, content.size());
  out += content;
}

std::string packed(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

TEST(DecodeAny, RandomMessagesInSlicesOfEverySize) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    v1::EvaluateRequest request = request_with_pairs(random() % 40, random);
    if (round % 3 == 1) {
      const double value = static_cast<double>(round);
      request.mutable_pairs_f64()->add_wi(value);
    } else if (round % 7 == 2) {
      request.mutable_grid()->add_phi_d(0.25);
    }
    request.set_precision(static_cast<v1::Precision>(random() % 5));
    expect_same_as_generated(request.SerializeAsString(), 1 + random() % 50);
  }
}

TEST(DecodeAny, UnpackedFloats) {
  std::string pairs, request;
  for (float value : {1.F, 2.F, 3.F}) put_float(pairs, 1, value);
  put_bytes(pairs, 2, packed({4, 5, 6}));
  put_bytes(request, 4, pairs);
  expect_same_as_generated(request, 5);
  const auto decoded = decode<Request>(buffer_of(request));
  EXPECT_THAT(elements<float>(decoded->bytes, decoded->wi), ElementsAre(1, 2, 3));
}

TEST(DecodeAny, ArraysSplitOverSeveralFields) {
  std::string pairs, request;
  put_bytes(pairs, 2, packed({4, 5}));
  put_bytes(pairs, 1, packed({1, 2}));
  put_bytes(pairs, 2, packed({6}));
  put_float(pairs, 1, 3);
  put_bytes(request, 4, pairs);
  expect_same_as_generated(request, 3);
  const auto decoded = decode<Request>(buffer_of(request));
  EXPECT_THAT(elements<float>(decoded->bytes, decoded->wo), ElementsAre(4, 5, 6));
}

TEST(DecodeAny, PairsGivenTwiceAreMerged) {
  std::string first, second, request;
  put_bytes(first, 1, packed({1}));
  put_bytes(second, 1, packed({2}));
  put_bytes(request, 4, first);
  put_bytes(request, 4, second);
  expect_same_as_generated(request, 100);
  const auto decoded = decode<Request>(buffer_of(request));
  EXPECT_THAT(elements<float>(decoded->bytes, decoded->wi), ElementsAre(1, 2));
}

TEST(DecodeAny, TheLastOfAOneofWins) {
  std::string pairs, grid, request;
  put_bytes(pairs, 1, packed({1}));
  put_tag(grid, 8, WireType::varint);
  put_varint(grid, 99);
  put_bytes(request, 6, grid);
  put_bytes(request, 4, pairs);
  expect_same_as_generated(request, 2);
  EXPECT_EQ(decode<Request>(buffer_of(request))->kind, Request::Kind::pairs);
}

TEST(DecodeAny, AMaterialGivenTwiceIsMerged) {
  v1::Material first, second;
  first.set_model("ggx");
  second.set_name("gold");
  std::string request;
  put_bytes(request, 1, first.SerializeAsString());
  put_bytes(request, 1, second.SerializeAsString());
  expect_same_as_generated(request, 3);
}

// Caches know a material by its bytes, and a map's entries come in any order.
TEST(DecodeAny, AMaterialBroughtIntoFormHasTheSameBytesAlways) {
  v1::Material material;
  material.set_model("ggx");
  for (const char* name : {"alpha_x", "alpha_y", "eta", "f0", "scale"})
    (*material.mutable_parameters()->mutable_fields())[name].set_number_value(0.5);
  std::string pairs, request;
  for (float value : {1.F, 2.F, 3.F}) put_float(pairs, 1, value);  // not packed
  put_bytes(request, 4, pairs);
  put_bytes(request, 1, to_bytes(material));
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(decode<Request>(buffer_of(request))->material, to_bytes(material));
}

TEST(DecodeAny, FieldsInAnotherOrderAndUnknownOnes) {
  std::string pairs, request;
  put_bytes(pairs, 2, packed({4, 5, 6}));
  put_bytes(pairs, 99, "from a newer client");
  put_bytes(pairs, 1, packed({1, 2, 3}));
  put_bytes(request, 4, pairs);
  put_bytes(request, 77, "likewise");
  put_bytes(request, 1, request_head().material().SerializeAsString());
  put_tag(request, 2, WireType::varint);
  put_varint(request, 2);
  expect_same_as_generated(request, 4);
}

TEST(DecodeAny, StreamRequestWithUnknownFieldsAndTheRequestFirst) {
  v1::EvaluateStreamRequest expected;
  expected.set_sequence(3);
  std::mt19937 random(1);
  *expected.mutable_evaluate() = request_with_pairs(2, random);
  std::string bytes;
  put_bytes(bytes, 3, expected.evaluate().SerializeAsString());
  put_bytes(bytes, 50, "unknown");
  put_tag(bytes, 1, WireType::varint);
  put_varint(bytes, 3);
  const auto decoded = decode<StreamRequest>(buffer_of(bytes, 6));
  ASSERT_TRUE(decoded.ok() && decoded->request.ok());
  EXPECT_EQ(decoded->sequence, 3U);
  EXPECT_EQ(decoded->request->wi.count, 6U);
}

TEST(DecodeAny, ABrokenRequestSpoilsItsChunkOnly) {
  std::string bytes;
  put_tag(bytes, 1, WireType::varint);
  put_varint(bytes, 12);
  put_bytes(bytes, 3, "\xff\xff\xff");
  const auto decoded = decode<StreamRequest>(buffer_of(bytes));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded->sequence, 12U);
  ASSERT_FALSE(decoded->request.ok());
  EXPECT_EQ(decoded->request.error().code, ErrorCode::invalid_argument);
}

TEST(DecodeAny, UnpackedValuesOfAResponse) {
  std::string bytes;
  put_float(bytes, 4, 1);
  put_float(bytes, 4, 2);
  const auto decoded = decode<Response>(buffer_of(bytes));
  ASSERT_TRUE(decoded.ok());
  EXPECT_THAT(elements<float>(decoded->bytes, decoded->values), ElementsAre(1, 2));
}

}  // namespace
}  // namespace gonio::wire::testing
