// The numbers that samples are drawn by: what their papers say, in [0, 1), the same for any slice.
#include "gonio/engine/random_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace gonio::testing {
namespace {

template <class T>
struct Numbers {
  std::vector<T> xi[3];
  Numbers(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi,
          std::size_t count) {
    for (auto& x : xi) x.assign(count, T(-1));
    random_numbers(source, first, per_wi, count, {xi[0].data(), xi[1].data(), xi[2].data()});
  }
};

template <class T>
class RandomNumbersOf : public ::testing::Test {};
using Types = ::testing::Types<float, double>;
TYPED_TEST_SUITE(RandomNumbersOf, Types);

// The words behind float64's numbers.
std::vector<std::uint32_t> words(const Numbers<double>& numbers, std::size_t i) {
  std::vector<std::uint32_t> all;
  for (const auto& x : numbers.xi) all.push_back(static_cast<std::uint32_t>(x[i] * 0x1p32));
  return all;
}

// The first of the known answers that the paper's authors publish (Random123, kat_vectors).
TEST(RandomNumbers, ArePhiloxOfTheSeedAndTheSample) {
  const Numbers<double> zero({Sequence::random, 0}, 0, 1, 1);
  EXPECT_EQ(words(zero, 0), (std::vector<std::uint32_t>{0x6627e8d5, 0xe169c58d, 0xbc57ac4c}));
}

// Salmon et al. 2011, section 3.3: all four words of a counter of four. The other known answers
// have more in the counter than a sample's number, so they hold this, and this holds the library.
std::vector<std::uint32_t> philox(std::array<std::uint32_t, 4> c, std::array<std::uint32_t, 2> k) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t p0 = 0xD2511F53ULL * c[0], p1 = 0xCD9E8D57ULL * c[2];
    c = {static_cast<std::uint32_t>(p1 >> 32) ^ c[1] ^ k[0], static_cast<std::uint32_t>(p1),
         static_cast<std::uint32_t>(p0 >> 32) ^ c[3] ^ k[1], static_cast<std::uint32_t>(p0)};
    k[0] += 0x9E3779B9, k[1] += 0xBB67AE85;
  }
  return {c.begin(), c.end()};
}

TEST(RandomNumbers, ArePhiloxOfLargeSeedsAndSamples) {
  constexpr std::uint32_t kOnes = 0xffffffff;
  ASSERT_EQ(philox({kOnes, kOnes, kOnes, kOnes}, {kOnes, kOnes}),
            (std::vector<std::uint32_t>{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  ASSERT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (std::vector<std::uint32_t>{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
  for (const std::uint64_t sample : {0x243f6a8885a308d3ULL, 1ULL << 32, 0xfffffffeULL}) {
    for (const std::uint64_t seed : {0x13198a2e03707344ULL, 1ULL, ~0ULL}) {
      // Runs that are longer than a packet and cross a multiple of 2^32.
      constexpr std::size_t kCount = 40;
      const Numbers<double> numbers({Sequence::random, seed}, sample, 1, kCount);
      for (std::size_t i = 0; i < kCount; ++i) {
        const std::uint64_t at = sample + i;
        auto want =
            philox({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at >> 32), 0, 0},
                   {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
        want.pop_back();
        ASSERT_EQ(words(numbers, i), want) << sample << " + " << i << ", seed " << seed;
      }
    }
  }
}

TYPED_TEST(RandomNumbersOf, AreTheSameForAnySlice) {
  constexpr std::size_t kCount = 700;
  for (const Sequence sequence : {Sequence::random, Sequence::sobol}) {
    for (const std::uint64_t per_wi : {1ULL, 7ULL, 64ULL, 1000ULL, 1ULL << 40}) {
      const std::uint64_t start = 5 * per_wi + 3;
      const Numbers<TypeParam> whole({sequence, 42}, start, per_wi, kCount);
      for (const std::size_t size : {1, 2, 15, 16, 17, 63, 512}) {
        for (std::size_t begin = 0; begin < kCount; begin += size) {
          const std::size_t n = std::min(size, kCount - begin);
          const Numbers<TypeParam> slice({sequence, 42}, start + begin, per_wi, n);
          for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < n; ++i)
              ASSERT_EQ(slice.xi[k][i], whole.xi[k][begin + i]) << begin << " + " << i;
          }
        }
      }
    }
  }
}

TYPED_TEST(RandomNumbersOf, LieInTheUnitInterval) {
  for (const Sequence sequence : {Sequence::random, Sequence::sobol}) {
    constexpr std::size_t kCount = 1 << 18;
    const Numbers<TypeParam> numbers({sequence, 7}, 0, 1 << 16, kCount);
    for (const auto& x : numbers.xi) {
      double sum = 0, squares = 0;
      for (const TypeParam v : x) {
        ASSERT_TRUE(v >= 0 && v < 1) << v;
        sum += static_cast<double>(v), squares += static_cast<double>(v) * static_cast<double>(v);
      }
      EXPECT_NEAR(sum / kCount, 0.5, 5 * std::sqrt(1. / 12 / kCount));
      EXPECT_NEAR(squares / kCount, 1. / 3, 5 * std::sqrt(4. / 45 / kCount));
    }
  }
}

TYPED_TEST(RandomNumbersOf, AreThoseOfFloat64Cut) {
  for (const Sequence sequence : {Sequence::random, Sequence::sobol}) {
    const Numbers<TypeParam> some({sequence, 3}, 100, 50, 300);
    const Numbers<double> exact({sequence, 3}, 100, 50, 300);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 300; ++i)
        EXPECT_NEAR(static_cast<double>(some.xi[k][i]), exact.xi[k][i], 0x1p-24);
    }
  }
}

// The cells of 2^(k-j) x 2^j that hold a point: all 2^k do, for each j, if the points are a (0, k,
// 2)-net.
void expect_net(const Numbers<double>& numbers, std::size_t first, int k, std::size_t a,
                std::size_t b) {
  for (int j = 0; j <= k; ++j) {
    std::set<std::pair<int, int>> cells;
    for (std::size_t i = first; i < first + (std::size_t{1} << k); ++i) {
      cells.emplace(static_cast<int>(std::ldexp(numbers.xi[a][i], k - j)),
                    static_cast<int>(std::ldexp(numbers.xi[b][i], j)));
    }
    ASSERT_EQ(cells.size(), std::size_t{1} << k) << "2^" << k << " from " << first << ", " << j;
  }
}

TEST(SobolNumbers, AreStratifiedInEveryDimensionAndANetInTheDirections) {
  constexpr std::uint64_t kPerWi = 1 << 12;
  for (const std::uint64_t wi : {0ULL, 3ULL, 1ULL << 33}) {
    const Numbers<double> numbers({Sequence::sobol, 11}, wi * kPerWi, kPerWi, kPerWi);
    for (int k = 0; k <= 12; ++k) {
      const std::size_t run = std::size_t{1} << k;
      // The first, another and the last run of this size.
      for (const std::size_t first : {std::size_t{0}, kPerWi / 2 / run * run, kPerWi - run}) {
        expect_net(numbers, first, k, 1, 2);
        std::set<int> strata;
        for (std::size_t i = first; i < first + run; ++i)
          strata.insert(static_cast<int>(std::ldexp(numbers.xi[0][i], k)));
        ASSERT_EQ(strata.size(), run) << "the choice, 2^" << k << " from " << first;
      }
    }
  }
}

// How many of the first numbers of every dimension two sources share.
std::size_t common(const NumberSource& a, std::uint64_t from_a, const NumberSource& b,
                   std::uint64_t from_b, std::uint64_t per_wi) {
  constexpr std::size_t kCount = 64;
  const Numbers<double> x(a, from_a, per_wi, kCount), y(b, from_b, per_wi, kCount);
  std::size_t same = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < kCount; ++i) same += x.xi[k][i] == y.xi[k][i] ? 1 : 0;
  }
  return same;
}

TEST(SobolNumbers, DifferForEachWiAndSeed) {
  const NumberSource source{Sequence::sobol, 11}, other{Sequence::sobol, 12};
  EXPECT_EQ(common(source, 0, source, 64, 64), 0U);
  EXPECT_EQ(common(source, 0, source, 64ULL << 33, 64), 0U);
  EXPECT_EQ(common(source, 0, other, 0, 64), 0U);
  EXPECT_EQ(common(source, 0, {Sequence::random, 11}, 0, 64), 0U);
  EXPECT_EQ(common({Sequence::random, 1}, 0, {Sequence::random, 2}, 0, 64), 0U);
}

}  // namespace
}  // namespace gonio::testing
