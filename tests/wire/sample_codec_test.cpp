// The codec of Sample and Integrate: what it writes is what the generated code writes, and any
// legal protobuf is read as the generated parser reads it.
#include <gmock/gmock.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include "wire/codec.h"
#include "wire/fields.h"
#include "wire/messages.h"
#include "wire/mutated.h"

namespace gonio::wire::testing {
namespace {

using google::protobuf::util::MessageDifferencer;
using ::testing::ElementsAre;
using ::testing::ElementsAreArray;

v1::SampleRequest sample_head() {
  v1::SampleRequest head;
  *head.mutable_material() = request_head().material();
  head.set_per_wi(9);
  head.set_sequence(v1::SEQUENCE_SOBOL);
  head.set_seed(1ULL << 60);
  head.set_count(4);
  return head;
}

v1::SampleRequest random_request(std::mt19937& random) {
  v1::SampleRequest request = sample_head();
  const auto wi = random_floats(3 * (random() % 9), random),
             xi = random_floats(random() % 9, random);
  request.mutable_wi()->Add(wi.begin(), wi.end());
  if (random() % 2 == 0) request.mutable_xi()->Add(xi.begin(), xi.end());
  if (random() % 4 == 0) request.mutable_wi_f64()->Add(wi.begin(), wi.end());
  if (random() % 4 == 0) request.mutable_xi_f64()->Add(xi.begin(), xi.end());
  return request;
}

template <class T>
void add(const SliceBytes& bytes, const Array& array, google::protobuf::RepeatedField<T>* to) {
  const auto numbers = elements<T>(bytes, array);
  to->Add(numbers.begin(), numbers.end());
}

// Put back into one message, for comparison. The codec leaves the material to others.
bool rebuild(const SampleRequest& decoded, v1::SampleRequest& to) {
  to = decoded.head;
  add(decoded.bytes, decoded.wi, to.mutable_wi());
  add(decoded.bytes, decoded.wi_f64, to.mutable_wi_f64());
  add(decoded.bytes, decoded.xi, to.mutable_xi());
  add(decoded.bytes, decoded.xi_f64, to.mutable_xi_f64());
  return !decoded.material || to.mutable_material()->ParseFromString(*decoded.material);
}

void expect_same_as_generated(const std::string& bytes, std::size_t slice) {
  v1::SampleRequest expected, rebuilt;
  const bool legal = expected.ParseFromString(bytes);
  const auto decoded = decode<SampleRequest>(buffer_of(bytes, slice));
  ASSERT_EQ(decoded.ok() && rebuild(*decoded, rebuilt), legal);
  if (!legal) return;
  expected.DiscardUnknownFields();
  rebuilt.DiscardUnknownFields();
  EXPECT_EQ(rebuilt.SerializeAsString(), expected.SerializeAsString());
}

TEST(SampleCodec, RequestIsWrittenAsTheGeneratedCodeDoes) {
  const std::vector<float> wi = {1, 2, 3}, xi = {4, 5, 6};
  v1::SampleStreamRequest parsed;
  ASSERT_TRUE(parsed.ParseFromString(text_of(encode_stream_request(
      7, 2, sample_head().SerializeAsString(), SampleSlices{slice_of(wi), slice_of(xi), false}))));
  EXPECT_EQ(parsed.sequence(), 7U);
  EXPECT_EQ(parsed.slot(), 2U);
  EXPECT_THAT(parsed.sample().wi(), ElementsAreArray(wi));
  EXPECT_THAT(parsed.sample().xi(), ElementsAreArray(xi));
  EXPECT_EQ(parsed.sample().seed(), 1ULL << 60);
  const std::vector<double> wide = {1.5, 2.5, 3.5};
  v1::SampleRequest unary;
  ASSERT_TRUE(unary.ParseFromString(text_of(
      encode_request(sample_head().SerializeAsString(), SampleSlices{slice_of(wide), {}, true}))));
  EXPECT_THAT(unary.wi_f64(), ElementsAreArray(wide));
  EXPECT_EQ(unary.wi_size() + unary.xi_size() + unary.xi_f64_size(), 0);
}

TEST(SampleCodec, ResponseRoundTrip) {
  const std::vector<float> weights = {1, 2, 3, 4}, pdf = {5, 6}, wo = {7, 8, 9, 10, 11, 12};
  SampleResponseParts parts;
  parts.head.set_channels(2);
  parts.head.set_lost(1);
  parts.flags = slice_of(std::vector<std::uint8_t>{0, 16});
  parts.values = slice_of(weights), parts.pdf = slice_of(pdf), parts.wo = slice_of(wo);
  const std::string written = text_of(encode_stream_response(12, parts));
  v1::SampleStreamResponse parsed;
  ASSERT_TRUE(parsed.ParseFromString(written));
  EXPECT_EQ(parsed.SerializeAsString(), written);
  EXPECT_THAT(parsed.sample().weights(), ElementsAreArray(weights));
  EXPECT_THAT(parsed.sample().wo(), ElementsAreArray(wo));
  const auto decoded = decode<SampleStreamResponse>(buffer_of(written, 5));
  ASSERT_TRUE(decoded.ok());
  const auto& response = std::get<SampleResponse>(decoded->result);
  EXPECT_EQ(response.head.lost(), 1U);
  EXPECT_FALSE(response.is_f64);
  EXPECT_THAT(elements<float>(response.bytes, response.values), ElementsAreArray(weights));
  EXPECT_THAT(elements<float>(response.bytes, response.pdf), ElementsAreArray(pdf));
  EXPECT_THAT(elements<float>(response.bytes, response.wo), ElementsAreArray(wo));
  EXPECT_THAT(elements<std::uint8_t>(response.bytes, response.flags), ElementsAre(0, 16));
}

TEST(SampleCodec, ArraysOfBothTypesInOneResponseAreRefused) {
  v1::SampleResponse response;
  response.add_weights(1);
  response.add_pdf_f64(1);
  EXPECT_FALSE(decode<SampleResponse>(buffer_of(response.SerializeAsString())).ok());
}

TEST(SampleCodec, UnpackedAndSplitArraysAreRead) {
  std::string bytes;
  for (const float value : {1.F, 2.F}) {
    put_tag(bytes, v1::SampleRequest::kWiFieldNumber, WireType::fixed32);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  const float third = 3;
  put_header(bytes, v1::SampleRequest::kWiFieldNumber, sizeof third);
  bytes.append(reinterpret_cast<const char*>(&third), sizeof third);
  expect_same_as_generated(bytes, 3);
  const auto decoded = decode<SampleRequest>(buffer_of(bytes));
  EXPECT_THAT(elements<float>(decoded->bytes, decoded->wi), ElementsAre(1, 2, 3));
}

TEST(SampleFuzz, MutatedRequestsAgreeWithTheGeneratedParser) {
  const google::protobuf::LogSilencer silent;
  std::mt19937 random(50'000);
  for (int round = 0; round < 20'000; ++round) {
    SCOPED_TRACE(round);
    expect_same_as_generated(mutated(random_request(random).SerializeAsString(), random),
                             1 + random() % 40);
    if (HasFatalFailure()) return;
  }
}

TEST(SampleFuzz, MutatedMessagesDoNotCrash) {
  const google::protobuf::LogSilencer silent;
  std::mt19937 random(60'000);
  for (int round = 0; round < 10'000; ++round) {
    v1::SampleStreamRequest chunk;
    chunk.set_sequence(random());
    *chunk.mutable_sample() = random_request(random);
    const auto buffer = buffer_of(mutated(chunk.SerializeAsString(), random), 1 + random() % 40);
    v1::SampleRequest rebuilt;
    const auto decoded = decode<SampleStreamRequest>(buffer);
    if (decoded.ok() && decoded->request.ok()) rebuild(*decoded->request, rebuilt);
    const auto response = decode<SampleStreamResponse>(buffer);
    if (response.ok() && std::holds_alternative<SampleResponse>(response->result)) {
      const auto& found = std::get<SampleResponse>(response->result);
      if (!found.is_f64) elements<float>(found.bytes, found.wo);
    }
    const auto integrate = decode<IntegrateRequest>(buffer);
    if (integrate.ok()) elements<float>(integrate->bytes, integrate->wi);
  }
}

}  // namespace
}  // namespace gonio::wire::testing
