// Integrate: albedos and their errors, whatever the threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "server/support/sample_requests.h"
#include "server/work/moments.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

v1::IntegrateRequest ggx_albedo(const std::vector<float>& wi, std::uint64_t per_wi) {
  v1::IntegrateRequest request;
  set_ggx(*request.mutable_material());
  request.mutable_wi()->Add(wi.begin(), wi.end());
  request.set_per_wi(per_wi);
  return request;
}

v1::IntegrateResponse integrated(TestServer& server, const v1::IntegrateRequest& request) {
  v1::IntegrateResponse response;
  const grpc::Status status = integrate(server, request, &response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return response;
}

Error integrate_refused(TestServer& server, const v1::IntegrateRequest& request) {
  v1::IntegrateResponse response;
  const grpc::Status status = integrate(server, request, &response);
  EXPECT_FALSE(status.ok());
  return wire::from_status(status);
}

TEST(Moments, MergeAsIfTakenTogether) {
  const std::vector<double> values = {3, 1, 4, 1, 5, 9, 2, 6, 5, 3};
  const Moments all = Moments::of(values.data(), 1, 10);
  EXPECT_DOUBLE_EQ(all.mean, 3.9);
  EXPECT_NEAR(all.squares, 54.9, 1e-12);
  Moments merged;
  merged.merge(0, Moments::of(values.data(), 1, 3), 3);
  merged.merge(3, Moments::of(&values[3], 1, 7), 7);
  EXPECT_NEAR(merged.mean, all.mean, 1e-14);
  EXPECT_NEAR(merged.squares, all.squares, 1e-12);
  EXPECT_DOUBLE_EQ(Moments::of(values.data(), 2, 5).mean, 3.8);  // 3, 4, 5, 2, 5
}

// More samples than a block holds, so that blocks are merged.
TEST(Integrate, IsTheMeanOfTheWeightsAndTheirError) {
  TestServer server;
  const std::vector<float> wi = {0.6F, 0, 0.8F, 0.99F, 0, 0.14106736F};
  constexpr std::uint64_t kSamples = 100'000;
  v1::IntegrateRequest request = ggx_albedo(wi, kSamples);
  request.set_seed(5);
  const v1::IntegrateResponse response = integrated(server, request);
  const CoreSamples<float> drawn(core_ggx(), wi, kSamples, {Sequence::random, 5});
  ASSERT_EQ(response.albedo_size(), 6);
  for (int k = 0; k < 6; ++k) {
    const int i = k / 3, c = k % 3;
    const float* first =
        &drawn.weights[static_cast<std::size_t>(i) * 3 * kSamples + static_cast<std::size_t>(c)];
    const Moments expected = Moments::of(first, 3, kSamples);
    EXPECT_NEAR(response.albedo(k), expected.mean, 1e-12);
    EXPECT_NEAR(response.standard_error(k), std::sqrt(expected.squares / (kSamples - 1) / kSamples),
                1e-12);
  }
  EXPECT_NEAR((response.lost(0) + response.lost(1)) * kSamples,
              static_cast<double>(drawn.report.lost), 0.01);
  EXPECT_GT(response.lost(1), 0);
  EXPECT_EQ(response.flags(), "");
}

TEST(Integrate, ThreadsChangeNoBitAndSlicesAreTheSame) {
  ServerOptions options;
  options.threads = 1;
  TestServer one(options);
  options.threads = 3;
  TestServer three(options);
  const auto wi = random_directions(9);
  const v1::IntegrateResponse all = integrated(one, ggx_albedo(wi, 70'000));
  const v1::IntegrateResponse again = integrated(three, ggx_albedo(wi, 70'000));
  EXPECT_EQ(vector_of<double>(again.albedo()), vector_of<double>(all.albedo()));
  EXPECT_EQ(vector_of<double>(again.standard_error()), vector_of<double>(all.standard_error()));
  v1::IntegrateRequest last = ggx_albedo({wi.end() - 3, wi.end()}, 70'000);
  last.set_first_wi(8);
  EXPECT_EQ(integrated(three, last).albedo(1), all.albedo(25));
}

// A Lambertian surface is drawn by the cosine: every weight is its albedo.
TEST(Integrate, OfALambertianSurfaceIsExact) {
  TestServer server;
  v1::IntegrateRequest request;
  request.mutable_material()->set_model("lambertian");
  (*request.mutable_material()->mutable_parameters()->mutable_fields())["rd"].set_number_value(0.5);
  for (const double x : {0.6, 0.0, 0.8}) request.add_wi_f64(x);
  request.set_precision(v1::PRECISION_REFERENCE);
  request.set_per_wi(5000);
  const v1::IntegrateResponse response = integrated(server, request);
  EXPECT_NEAR(response.albedo(0), 0.5, 1e-14);
  EXPECT_LT(response.standard_error(0), 1e-14);
  EXPECT_EQ(response.lost(0), 0);
}

TEST(Integrate, BadDirectionsAreFlagged) {
  TestServer server;
  const std::vector<float> wi = {0, 0, 1, 0, 0, -1, 0.6F, 0, 0.8F};
  const v1::IntegrateResponse response = integrated(server, ggx_albedo(wi, 200));
  EXPECT_EQ(response.flags(), std::string("\0\x08\0", 3));
  EXPECT_EQ(response.albedo(3), 0);
  EXPECT_GT(response.albedo(6), 0.5);
}

TEST(Integrate, SaysWhatIsWrong) {
  TestServer server;
  const auto wi = random_directions(2);
  EXPECT_EQ(integrate_refused(server, ggx_albedo(wi, 0)).field, "per_wi");
  EXPECT_THAT(integrate_refused(server, ggx_albedo(wi, 1)).allowed, HasSubstr("2 to"));
  const Error many = integrate_refused(server, ggx_albedo(wi, 1'000'000'000'000));
  EXPECT_EQ(many.field, "per_wi");
  EXPECT_THAT(many.allowed, HasSubstr("4294967296 samples"));
  v1::IntegrateRequest odd = ggx_albedo(wi, 2);
  odd.add_wi(1);
  EXPECT_EQ(integrate_refused(server, odd).field, "wi");
}

}  // namespace
}  // namespace gonio::server::testing
