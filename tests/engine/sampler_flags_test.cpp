// Bad directions and numbers are flagged exactly, draw nothing, and their neighbours do not notice.
#include <gtest/gtest.h>

#include <limits>

#include "engine/samples.h"

namespace gonio::testing {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Bad {
  std::array<double, 3> wi, xi;
  int flags;
};
constexpr std::array<double, 3> kGoodWi{0.6, 0, 0.8}, kGoodXi{0.3, 0.6, 0.9};

const std::vector<Bad>& bad_samples() {
  static const std::vector<Bad> all{
      {{kNan, 0, 1}, kGoodXi, flag::not_finite},
      {{0, -kInfinity, 1}, kGoodXi, flag::not_finite},
      {{0, 0, 0}, kGoodXi, flag::zero},
      {{0, 0, 1.0011}, kGoodXi, flag::not_unit},
      {{3e38, 3e38, 3e38}, kGoodXi, flag::not_unit},
      {{0, 0, -1}, kGoodXi, flag::incident_below_horizon},
      {{1, 0, 0}, kGoodXi, flag::incident_below_horizon},
      {{0, 0, -2}, kGoodXi, flag::incident_below_horizon | flag::not_unit},
      {kGoodWi, {-1e-30, 0.5, 0.5}, flag::bad_number},
      {kGoodWi, {0.5, 1, 0.5}, flag::bad_number},
      {kGoodWi, {0.5, 0.5, kNan}, flag::bad_number},
      {kGoodWi, {kInfinity, 0.5, 0.5}, flag::bad_number},
      {kGoodWi, {0.5, -kInfinity, 1e30}, flag::bad_number},
      {{0, 0, 0}, {0.5, 0.5, -1}, flag::zero | flag::bad_number},
      {{0.6, 0, -0.8}, {2, 2, 2}, flag::incident_below_horizon | flag::bad_number}};
  return all;
}

template <class T>
class SamplerFlagsOf : public ::testing::Test {
 protected:
  static Request<T> good(std::size_t count) {
    Request<T> request{random_pairs<T>(count, 6).wi, 1};
    std::vector<T> apart(3 * count);
    random_numbers({Sequence::random, 2}, 0, 1, count,
                   {apart.data(), apart.data() + count, apart.data() + 2 * count});
    for (std::size_t i = 0; i < 3 * count; ++i) request.xi.push_back(apart[i % 3 * count + i / 3]);
    return request;
  }
  static void put(Request<T>& request, std::size_t i, const Bad& bad) {
    for (std::size_t c = 0; c < 3; ++c) {
      request.wi[3 * i + c] = static_cast<T>(bad.wi[c]);
      request.xi[3 * i + c] = static_cast<T>(bad.xi[c]);
    }
  }
};
using Types = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SamplerFlagsOf, Types);

TYPED_TEST(SamplerFlagsOf, EveryBadSampleIsSaidToBeSo) {
  using T = TypeParam;
  for_all_samplers([this](const Sampler& sampler, Isa isa) {
    for (const Bad& bad : bad_samples()) {
      Request<T> request = this->good(1);
      this->put(request, 0, bad);
      const Drawn<T> drawn = draw(sampler, request, isa);
      ASSERT_EQ(drawn.flags[0], bad.flags) << bad.wi[2] << " " << bad.xi[0];
      EXPECT_EQ(drawn.report.any_flags, bad.flags);
      EXPECT_EQ(drawn.report.lost, 0U);
      EXPECT_EQ(drawn.wo, std::vector<T>(3));
      EXPECT_EQ(drawn.pdf, std::vector<T>(1));
      EXPECT_EQ(drawn.weights, std::vector<T>(drawn.weights.size()));
    }
  });
}

TYPED_TEST(SamplerFlagsOf, NumbersAtTheirEndsAreTaken) {
  using T = TypeParam;
  const T most = 1 - std::numeric_limits<T>::epsilon() / 2;
  Request<T> request = this->good(8);
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k < 3; ++k) request.xi[3 * i + k] = (i >> k & 1) != 0 ? most : T(0);
  }
  for_all_samplers([&](const Sampler& sampler, Isa isa) {
    const Drawn<T> drawn = draw(sampler, request, isa);
    EXPECT_EQ(drawn.report.any_flags & ~flag::outgoing_below_horizon, 0);
    for (std::size_t i = 0; i < 8; ++i) {
      const T* w = &drawn.wo[3 * i];
      EXPECT_NEAR(static_cast<double>(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]), 1, 2e-6) << i;
      EXPECT_TRUE(std::isfinite(drawn.pdf[i]) && drawn.pdf[i] >= 0) << i;
    }
    for (const T weight : drawn.weights) EXPECT_TRUE(std::isfinite(weight) && weight >= 0);
  });
}

TYPED_TEST(SamplerFlagsOf, NeighboursDoNotNotice) {
  using T = TypeParam;
  constexpr std::size_t kCount = 1100;
  const Request<T> good = this->good(kCount);
  Request<T> mixed = good;
  std::vector<int> bad_flags(kCount);
  std::mt19937 random(9);
  for (std::size_t i = 0; i < kCount; ++i) {
    // Runs of bad ones, single ones, and stretches without.
    if (!(i < 20 || i >= kCount - 3 || (i > 500 && random() % 5 == 0))) continue;
    const Bad& bad = bad_samples()[random() % bad_samples().size()];
    this->put(mixed, i, bad);
    bad_flags[i] = bad.flags;
  }
  for_all_samplers([&](const Sampler& sampler, Isa isa) {
    Drawn<T> want = draw(sampler, good, isa);
    const Drawn<T> got = draw(sampler, mixed, isa);
    const std::size_t channels = want.weights.size() / kCount;
    std::uint64_t lost = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      if (bad_flags[i] != 0) {
        want.flags[i] = static_cast<std::uint8_t>(bad_flags[i]);
        want.pdf[i] = 0;
        std::fill_n(&want.wo[3 * i], 3, T(0));
        std::fill_n(&want.weights[i * channels], channels, T(0));
      }
      lost += want.flags[i] == flag::outgoing_below_horizon ? 1 : 0;
    }
    ASSERT_TRUE(same(got, 0, want));
    EXPECT_EQ(got.report.lost, lost);
  });
}

// Rough metal seen at grazing loses samples; each is counted and keeps its direction.
TYPED_TEST(SamplerFlagsOf, LostSamplesAreCounted) {
  using T = TypeParam;
  const auto rough = Material::create(
      {LobeSpec{"ggx",
                {{"alpha_x", std::vector<double>{1}}, {"alpha_y", std::vector<double>{0.1}}}},
       {},
       {}});
  ASSERT_TRUE(rough.ok());
  const T cosine = static_cast<T>(0.1), sine = std::sqrt(1 - cosine * cosine);
  const Request<T> request{{sine * T(0.6), sine * T(0.8), cosine}, 5000};
  for (const Isa isa : supported_isas()) {
    const Drawn<T> drawn = draw(Sampler::create(*rough), request, isa);
    std::uint64_t lost = 0;
    for (std::size_t i = 0; i < drawn.pdf.size(); ++i) {
      if (drawn.flags[i] == 0) continue;
      ++lost;
      ASSERT_EQ(drawn.flags[i], flag::outgoing_below_horizon);
      EXPECT_LE(drawn.wo[3 * i + 2], 0);
      EXPECT_EQ(drawn.pdf[i], 0);
      EXPECT_EQ(drawn.weights[i], 0);
    }
    EXPECT_EQ(drawn.report.lost, lost);
    EXPECT_GT(lost, 50U);
    EXPECT_EQ(drawn.report.any_flags, flag::outgoing_below_horizon);
  }
}

}  // namespace
}  // namespace gonio::testing
