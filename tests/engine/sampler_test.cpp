// A sample depends on its wi and its numbers alone: not on the batch, its slices or its layout.
#include "gonio/engine/sampler.h"

#include <gtest/gtest.h>

#include "engine/samples.h"

namespace gonio::testing {
namespace {

template <class T>
class SamplerOf : public ::testing::Test {};
using Types = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SamplerOf, Types);

TYPED_TEST(SamplerOf, SlicesAreThoseOfTheWhole) {
  using T = TypeParam;
  for_all_samplers([](const Sampler& sampler, Isa isa) {
    for (const Sequence sequence : {Sequence::random, Sequence::sobol}) {
      for (const std::uint64_t per_wi : {1, 7, 64}) {
        Request<T> request{random_pairs<T>(600 / per_wi + 2).wi, per_wi};
        request.numbers = {sequence, 5};
        const Drawn<T> whole = draw(sampler, request, isa);
        for (const std::size_t size : {1, 5, 16, 17, 100, 513}) {
          std::uint64_t lost = 0;
          std::uint8_t any = 0;
          for (std::size_t first = 0; first < request.samples(); first += size) {
            const std::size_t n = std::min(size, request.samples() - first);
            const Drawn<T> slice = draw(sampler, request, first, n, isa);
            ASSERT_TRUE(same(whole, first, slice)) << "per wi " << per_wi << ", size " << size;
            lost += slice.report.lost, any |= slice.report.any_flags;
          }
          EXPECT_EQ(lost, whole.report.lost);
          EXPECT_EQ(any, whole.report.any_flags);
        }
      }
    }
  });
}

TYPED_TEST(SamplerOf, GivenNumbersAreAsGoodAsGenerated) {
  using T = TypeParam;
  Request<T> generated{random_pairs<T>(100).wi, 9};
  generated.numbers = {Sequence::sobol, 8};
  Request<T> given = generated;
  const std::size_t count = given.samples();
  std::vector<T> apart(3 * count);
  random_numbers(given.numbers, 0, given.per_wi, count,
                 {apart.data(), apart.data() + count, apart.data() + 2 * count});
  for (std::size_t i = 0; i < 3 * count; ++i) given.xi.push_back(apart[i % 3 * count + i / 3]);
  for_all_samplers([&](const Sampler& sampler, Isa isa) {
    ASSERT_TRUE(same(draw(sampler, generated, isa), 0, draw(sampler, given, isa)));
  });
}

// Weights in any order, or none; directions apart; no flags.
TYPED_TEST(SamplerOf, AnyLayoutGivesTheSame) {
  using T = TypeParam;
  const Request<T> request{random_pairs<T>(90).wi, 11};
  const std::size_t count = request.samples();
  std::vector<T> apart(3 * 90);
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i % 3 * 90 + i / 3] = request.wi[i];
  for_all_samplers([&](const Sampler& sampler, Isa isa) {
    const auto channels = static_cast<std::size_t>(sampler.material().channels());
    const Drawn<T> want = draw(sampler, request, isa);
    Drawn<T> got(count, sampler.material().channels());
    SampleBatch<T> batch;
    batch.wi = Directions<T>::separate(apart.data(), apart.data() + 90, apart.data() + 180);
    batch.count = count, batch.per_wi = request.per_wi;
    batch.wo = got.wo.data(), batch.pdf = got.pdf.data();
    batch.weights = Values<T>::planar(got.weights.data(), count);
    sample(sampler, batch, isa);
    ASSERT_TRUE(same_bits(got.wo.data(), want.wo.data(), 3 * count));
    ASSERT_TRUE(same_bits(got.pdf.data(), want.pdf.data(), count));
    for (std::size_t i = 0; i < want.weights.size(); ++i) {
      const T* planar = &got.weights[i % channels * count + i / channels];
      ASSERT_TRUE(same_bits(planar, &want.weights[i], 1)) << "weight " << i;
    }
    const std::vector<T> weights = got.weights;
    batch.weights = {};
    std::ranges::fill(got.wo, T(-1));
    sample(sampler, batch, isa);
    ASSERT_TRUE(same_bits(got.wo.data(), want.wo.data(), 3 * count));
    EXPECT_EQ(got.weights, weights) << "written without being asked for";
  });
}

TYPED_TEST(SamplerOf, DirectionsAreUnitAndDensitiesPositive) {
  using T = TypeParam;
  const Request<T> request{random_pairs<T>(300).wi, 10};
  for_all_samplers([&](const Sampler& sampler, Isa isa) {
    const Drawn<T> drawn = draw(sampler, request, isa);
    std::uint64_t lost = 0;
    for (std::size_t i = 0; i < request.samples(); ++i) {
      const T* w = &drawn.wo[3 * i];
      const bool below = !(w[2] > 0);
      ASSERT_NEAR(static_cast<double>(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]), 1, 2e-6);
      ASSERT_EQ(drawn.flags[i], below ? flag::outgoing_below_horizon : 0) << "sample " << i;
      ASSERT_TRUE(below ? drawn.pdf[i] == 0 : drawn.pdf[i] > 0) << "sample " << i;
      lost += below ? 1 : 0;
    }
    EXPECT_EQ(drawn.report.lost, lost);
    EXPECT_EQ(drawn.report.any_flags, lost > 0 ? flag::outgoing_below_horizon : 0);
    for (const T weight : drawn.weights) ASSERT_TRUE(std::isfinite(weight) && weight >= 0);
  });
}

// Evaluation with densities flags what evaluation flags, and gives it no density.
TYPED_TEST(SamplerOf, EvaluationGivesTheSameDensitiesAndFlags) {
  using T = TypeParam;
  Request<T> request{random_pairs<T>(400).wi, 1};
  for (const std::size_t i : {3, 177, 399}) request.wi[3 * i + 2] = T(-0.5);
  for_all_samplers([&](const Sampler& sampler, Isa isa) {
    const Drawn<T> drawn = draw(sampler, request, isa);
    const std::size_t count = request.samples();
    const int channels = sampler.material().channels();
    std::vector<T> values(drawn.weights.size(), T(-7)), pdf(count, T(-7));
    std::vector<std::uint8_t> flags(count, 255), plain(count, 255);
    Batch<T, T> batch{Directions<T>::interleaved(request.wi.data()),
                      Directions<T>::interleaved(drawn.wo.data()), count,
                      Values<T>::interleaved(values.data(), channels), flags.data()};
    const std::uint8_t any = evaluate(sampler, batch, pdf.data(), isa);
    EXPECT_TRUE(same_bits(pdf.data(), drawn.pdf.data(), count));
    batch.flags = plain.data();
    EXPECT_EQ(any, evaluate(sampler.material(), batch, isa));
    EXPECT_EQ(flags, plain);
    EXPECT_EQ(flags[3], flag::incident_below_horizon | flag::not_unit | flag::zero);
  });
}

}  // namespace
}  // namespace gonio::testing
