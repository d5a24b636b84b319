// What the codec writes is what the generated code writes, and what it reads back is what was
// written.
#include "wire/codec.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include "gonio/v1/evaluate.pb.h"
#include "wire/messages.h"

namespace gonio::wire::testing {
namespace {

using google::protobuf::util::MessageDifferencer;
using ::testing::ElementsAreArray;

const std::vector<float> kWi = {1, 2, 3, 4, 5, 6}, kWo = {-1, -2, -3, -4, -5, -6};

PairSlices some_pairs() { return {slice_of(kWi), slice_of(kWo), false}; }

TEST(Encode, RequestIsAPlainMessage) {
  const PairSlices pairs = some_pairs();
  v1::EvaluateRequest parsed;
  ASSERT_TRUE(
      parsed.ParseFromString(text_of(encode_request(request_head().SerializeAsString(), pairs))));
  EXPECT_THAT(parsed.pairs().wi(), ElementsAreArray(kWi));
  EXPECT_THAT(parsed.pairs().wo(), ElementsAreArray(kWo));
  parsed.clear_directions();
  EXPECT_TRUE(MessageDifferencer::Equals(parsed, request_head()));
}

// Short arrays are copied beside the head, long ones are slices of their own.
TEST(Encode, ArraysOfAnyLengthAreWrittenAsTheGeneratedCodeDoes) {
  std::mt19937 random(3);
  for (const std::size_t count : {1, 2, 3, 5, 85, 86, 4001}) {
    const v1::EvaluateRequest request = request_with_pairs(count, random);
    const auto slice = [](const auto& numbers) {
      return grpc::Slice(numbers.data(), static_cast<std::size_t>(numbers.size()) * sizeof(float));
    };
    const PairSlices pairs{slice(request.pairs().wi()), slice(request.pairs().wo()), false};
    const std::string head = request_head().SerializeAsString();
    EXPECT_EQ(text_of(encode_request(head, pairs)), request.SerializeAsString()) << count;
  }
}

TEST(Encode, StreamRequestWithDoublesIsAPlainMessage) {
  const std::vector<double> wi = {.1, .2, .3}, wo = {.4, .5, .6};
  const PairSlices pairs{slice_of(wi), slice_of(wo), true};
  v1::EvaluateStreamRequest parsed;
  ASSERT_TRUE(parsed.ParseFromString(
      text_of(encode_stream_request(1ULL << 40, 255, request_head().SerializeAsString(), pairs))));
  EXPECT_EQ(parsed.sequence(), 1ULL << 40);
  EXPECT_EQ(parsed.slot(), 255U);
  EXPECT_THAT(parsed.evaluate().pairs_f64().wi(), ElementsAreArray(wi));
  EXPECT_THAT(parsed.evaluate().pairs_f64().wo(), ElementsAreArray(wo));
  EXPECT_EQ(parsed.evaluate().material().model(), "ggx");
}

TEST(Encode, EmptyBatchKeepsItsKind) {
  const PairSlices none;
  v1::EvaluateRequest parsed;
  ASSERT_TRUE(
      parsed.ParseFromString(text_of(encode_request(request_head().SerializeAsString(), none))));
  EXPECT_TRUE(parsed.has_pairs());
  const auto decoded = decode<Request>(encode_request(request_head().SerializeAsString(), none));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded->kind, Request::Kind::pairs);
  EXPECT_EQ(decoded->wi.count, 0U);
}

TEST(Encode, GridTravelsInTheHead) {
  v1::EvaluateRequest head = request_head();
  head.mutable_grid()->add_theta_h(0.5);
  head.mutable_grid()->set_count(7);
  const auto decoded =
      decode<StreamRequest>(encode_stream_request(9, 3, head.SerializeAsString(), {}));
  ASSERT_TRUE(decoded.ok() && decoded->request.ok());
  EXPECT_EQ(decoded->sequence, 9U);
  EXPECT_EQ(decoded->slot, 3U);
  EXPECT_EQ(decoded->request->kind, Request::Kind::grid);
  EXPECT_EQ(decoded->request->material, head.material().SerializeAsString());
  head.clear_material();
  EXPECT_TRUE(MessageDifferencer::Equals(decoded->request->head, head));
}

ResponseParts some_response() {
  ResponseParts parts;
  parts.head.set_channels(3);
  parts.head.mutable_report()->set_kernel_seconds(0.125);
  parts.head.mutable_report()->mutable_error_bound()->set_note("none");
  parts.flags = slice_of(std::vector<std::uint8_t>{0, 8});
  parts.values = slice_of(kWi);
  return parts;
}

TEST(Encode, ResponseIsAPlainMessage) {
  v1::EvaluateResponse parsed;
  ASSERT_TRUE(parsed.ParseFromString(text_of(encode_response(some_response()))));
  EXPECT_THAT(parsed.values(), ElementsAreArray(kWi));
  EXPECT_EQ(parsed.flags(), std::string("\0\x08", 2));
  EXPECT_EQ(parsed.channels(), 3U);
  EXPECT_EQ(parsed.report().error_bound().note(), "none");
}

TEST(Encode, FieldsAreWrittenInOrderAsTheGeneratedCodeDoes) {
  v1::EvaluateStreamResponse parsed;
  const std::string written = text_of(encode_stream_response(70'000, some_response()));
  ASSERT_TRUE(parsed.ParseFromString(written));
  EXPECT_EQ(parsed.SerializeAsString(), written);
}

TEST(Decode, StreamResponseRoundTrip) {
  ResponseParts parts = some_response();
  const std::vector<double> values = {1.5, 2.5, 3.5};
  parts.values = slice_of(values);
  parts.pdf = slice_of(std::vector<double>{4.5});
  parts.is_f64 = true;
  parts.flags = {};
  const auto decoded = decode<StreamResponse>(encode_stream_response(5, parts));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded->sequence, 5U);
  const auto& response = std::get<Response>(decoded->result);
  EXPECT_TRUE(response.is_f64);
  EXPECT_EQ(response.flags.count, 0U);
  EXPECT_THAT(elements<double>(response.bytes, response.values), ElementsAreArray(values));
  EXPECT_EQ(elements<double>(response.bytes, response.pdf), std::vector<double>{4.5});
  EXPECT_TRUE(MessageDifferencer::Equals(response.head, parts.head));
}

TEST(Decode, StreamErrorRoundTrip) {
  v1::ErrorDetail error;
  error.set_code(3);
  error.set_field("material.model");
  const auto decoded = decode<StreamResponse>(encode_stream_error(0, error));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded->sequence, 0U);
  EXPECT_TRUE(MessageDifferencer::Equals(std::get<v1::ErrorDetail>(decoded->result), error));
}

TEST(Bytes, CopyCrossesSlicesAndStepsOverEmptyOnes) {
  const std::vector<grpc::Slice> parts = {grpc::Slice("ab"), grpc::Slice(), grpc::Slice("c"),
                                          grpc::Slice("def")};
  const SliceBytes bytes(parts);
  EXPECT_EQ(bytes.size(), 6U);
  EXPECT_EQ(bytes.text(1, 4), "bcde");
  EXPECT_EQ(bytes.piece(2).size, 1U);
  EXPECT_EQ(bytes.piece(6).size, 0U);
}

}  // namespace
}  // namespace gonio::wire::testing
