// Sample: what comes back is what the core draws, in whatever runs it is asked for; and what is
// wrong with a request is said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "server/support/sample_requests.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

ServerOptions with_threads(int threads) {
  ServerOptions options;
  options.threads = threads;
  return options;
}

TEST(Sample, IsWhatTheCoreDraws) {
  TestServer server;
  const auto wi = random_directions(700);
  for (const auto sequence : {v1::SEQUENCE_RANDOM, v1::SEQUENCE_SOBOL}) {
    v1::SampleRequest request = sample_request(wi, 13);
    request.set_sequence(sequence);
    request.set_seed(99);
    const v1::SampleResponse response = sampled(server, request);
    const auto numbers = sequence == v1::SEQUENCE_SOBOL ? Sequence::sobol : Sequence::random;
    const CoreSamples<float> expected(core_ggx(), wi, 13, {numbers, 99});
    EXPECT_EQ(vector_of<float>(response.wo()), expected.wo);
    EXPECT_EQ(vector_of<float>(response.pdf()), expected.pdf);
    EXPECT_EQ(vector_of<float>(response.weights()), expected.weights);
    EXPECT_EQ(response.lost(), expected.report.lost);
    EXPECT_GT(response.lost(), 0U);
    EXPECT_EQ(vector_of<std::uint8_t>(response.flags()), expected.flags);
    EXPECT_EQ(response.channels(), 3U);
    EXPECT_GT(response.report().kernel_seconds(), 0);
  }
}

TEST(Sample, InFloat64WithDirectionsOfEitherType) {
  TestServer server;
  const auto wi = random_directions(50);
  const std::vector<double> wide(wi.begin(), wi.end());
  const CoreSamples<double> expected(core_ggx(), wide, 7, {Sequence::random, 3});
  for (const bool is_f64 : {false, true}) {
    v1::SampleRequest request = sample_request(is_f64 ? std::vector<float>() : wi, 7);
    if (is_f64) request.mutable_wi_f64()->Add(wide.begin(), wide.end());
    request.set_precision(v1::PRECISION_REFERENCE);
    request.set_seed(3);
    const v1::SampleResponse response = sampled(server, request);
    EXPECT_EQ(vector_of<double>(response.wo_f64()), expected.wo);
    EXPECT_EQ(vector_of<double>(response.pdf_f64()), expected.pdf);
    EXPECT_EQ(vector_of<double>(response.weights_f64()), expected.weights);
    EXPECT_EQ(response.weights_size(), 0);
  }
}

TEST(Sample, NumbersOfTheCallersOwn) {
  TestServer server;
  const auto wi = random_directions(20);
  std::vector<float> xi(3 * 20 * 5);
  std::mt19937 random(5);
  for (float& x : xi) x = std::uniform_real_distribution<float>(0, 0.999F)(random);
  xi[3] = 1, xi[7] = -0.5F, xi[11] = NAN;
  v1::SampleRequest request = sample_request(wi, 5);
  request.mutable_xi()->Add(xi.begin(), xi.end());
  const v1::SampleResponse response = sampled(server, request);
  const CoreSamples<float> expected(core_ggx(), wi, 5, {}, xi.data());
  EXPECT_EQ(vector_of<float>(response.wo()), expected.wo);
  EXPECT_EQ(vector_of<float>(response.weights()), expected.weights);
  for (const std::size_t bad : {1U, 2U, 3U}) {
    EXPECT_EQ(response.flags()[bad], v1::PAIR_FLAG_BAD_NUMBER);
    EXPECT_EQ(response.pdf(static_cast<int>(bad)), 0);
  }
}

// Any slice is the same bits, from servers of one thread and of several.
TEST(Sample, AnyRunCanBeAskedForAgain) {
  TestServer one(with_threads(1)), three(with_threads(3));
  const auto wi = random_directions(40);
  v1::SampleRequest request = sample_request(wi, 1000);
  request.set_seed(1);
  const v1::SampleResponse all = sampled(one, request);
  EXPECT_EQ(sampled(three, request).wo().size(), 3 * 40'000);
  EXPECT_EQ(vector_of<float>(sampled(three, request).weights()), vector_of<float>(all.weights()));
  // Samples 17,500 to 22,499, by the wi they belong to alone.
  request.mutable_wi()->Clear();
  request.mutable_wi()->Add(wi.begin() + 3 * 17, wi.begin() + 3 * 23);
  request.set_first_wi(17);
  request.set_first(500);
  request.set_count(5000);
  const v1::SampleResponse slice = sampled(three, request);
  ASSERT_EQ(slice.pdf_size(), 5000);
  for (int i = 0; i < 5000; ++i) {
    ASSERT_EQ(slice.pdf(i), all.pdf(17'500 + i));
    ASSERT_EQ(slice.wo(3 * i), all.wo(3 * (17'500 + i)));
  }
}

TEST(Sample, BadDirectionsAreFlaggedAndHurtNobodyElse) {
  TestServer server;
  auto wi = random_directions(4);
  wi[2] = -wi[2];
  wi[4] = NAN;
  const v1::SampleResponse response = sampled(server, sample_request(wi, 2));
  ASSERT_EQ(response.flags().size(), 8U);
  for (int i : {0, 1}) EXPECT_EQ(response.flags()[i], v1::PAIR_FLAG_INCIDENT_BELOW_HORIZON);
  for (int i : {2, 3}) {
    EXPECT_EQ(response.flags()[i], v1::PAIR_FLAG_NOT_FINITE);
    EXPECT_EQ(response.pdf(i), 0);
    EXPECT_EQ(response.wo(3 * i), 0);
  }
  const CoreSamples<float> expected(core_ggx(), wi, 2, {});
  EXPECT_EQ(response.pdf(7), expected.pdf[7]);
  EXPECT_EQ(response.lost(), expected.report.lost);  // bad ones are not lost
}

TEST(Sample, PdfOfEvaluateIsThePdfOfTheSample) {
  TestServer server;
  const auto wi = random_directions(300);
  const v1::SampleResponse drawn = sampled(server, sample_request(wi, 1));
  v1::EvaluateRequest request;
  set_ggx(*request.mutable_material());
  request.mutable_pairs()->mutable_wi()->Add(wi.begin(), wi.end());
  *request.mutable_pairs()->mutable_wo() = drawn.wo();
  const v1::EvaluateResponse plain = server.evaluated(request);
  EXPECT_EQ(plain.pdf_size(), 0);
  request.set_pdf(true);
  const v1::EvaluateResponse both = server.evaluated(request);
  EXPECT_EQ(vector_of<float>(both.pdf()), vector_of<float>(drawn.pdf()));
  EXPECT_EQ(vector_of<float>(both.values()), vector_of<float>(plain.values()));
  EXPECT_EQ(both.flags(), plain.flags());
  request.set_precision(v1::PRECISION_REFERENCE);
  const v1::EvaluateResponse exact = server.evaluated(request);
  ASSERT_EQ(exact.pdf_f64_size(), 300);
  EXPECT_EQ(exact.pdf_size(), 0);
  for (int i = 0; i < 300; ++i) {
    EXPECT_NEAR(exact.pdf_f64(i), drawn.pdf(i), 1e-5 * exact.pdf_f64(i));
  }
}

TEST(Sample, MaterialsThatAreEvaluatedAndSampledByName) {
  TestServer server;
  v1::SampleRequest request = sample_request(random_directions(2), 4);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(sampled(server, request).pdf_size(), 8);
  request.mutable_material()->Clear();
  request.mutable_material()->set_name("nothing");
  EXPECT_EQ(sample_refused(server, request).code, ErrorCode::not_found);
}

struct Case {
  void (*spoil)(v1::SampleRequest&);
  const char* field;
  const char* allowed;
};

TEST(Sample, SaysWhatIsWrong) {
  TestServer server;
  const Case cases[] = {
      {[](auto& r) { r.set_per_wi(0); }, "per_wi", "1 to"},
      {[](auto& r) { r.set_count(0); }, "count", "1 to 8"},
      {[](auto& r) { r.set_count(9); }, "count", "1 to 8"},
      {[](auto& r) { r.set_first(3), r.set_count(6); }, "count", "1 to 5"},
      {[](auto& r) { r.set_first(8); }, "first", "below 8"},
      {[](auto& r) { r.set_per_wi(1'000'000'000'000); }, "count", "at most 2"},
      {[](auto& r) { r.set_per_wi(UINT64_MAX); }, "per_wi", "2^62"},
      {[](auto& r) { r.set_first_wi(UINT64_MAX); }, "first_wi", "2^62"},
      {[](auto& r) { r.add_wi(1); }, "wi", "a multiple of 3"},
      {[](auto& r) { r.add_wi_f64(1); }, "wi", "wi or wi_f64"},
      {[](auto& r) { r.add_xi(0.5F); }, "xi", "three numbers for each of the 8"},
      {[](auto& r) { r.mutable_xi()->Resize(24, 0), r.set_seed(1); }, "xi", "one of the two"},
      {[](auto& r) { r.add_xi_f64(0.5); }, "precision", "PRECISION_REFERENCE for xi_f64"},
      {[](auto& r) { r.set_sequence(static_cast<v1::Sequence>(7)); }, "sequence", "SOBOL"},
      {[](auto& r) { r.clear_material(); }, "material", ""},
  };
  for (const Case& one : cases) {
    v1::SampleRequest request = sample_request(random_directions(2), 4);
    one.spoil(request);
    const Error error = sample_refused(server, request);
    EXPECT_EQ(error.code, ErrorCode::invalid_argument) << one.field;
    EXPECT_THAT(error.field, HasSubstr(one.field));
    EXPECT_THAT(error.allowed, HasSubstr(one.allowed)) << error.message;
  }
  EXPECT_EQ(sampled(server, sample_request(random_directions(2), 4)).pdf_size(), 8);
}

}  // namespace
}  // namespace gonio::server::testing
