// Every number of every row is rounded to float32, whatever the compiler makes of the loop.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "assess/places.h"
#include "gonio/engine/isa.h"
#include "numeric/compiler/loops.h"

namespace gonio::testing {
namespace {

constexpr std::size_t kSizes[] = {1, 2, 3, 4, 5, 6, 7, 9, 4001};

double truly_rounded(double x) {
  const volatile float narrow = static_cast<float>(x);
  return static_cast<double>(narrow);
}

std::vector<double> numbers(std::size_t count) {
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = 1 / (3 + static_cast<double>(i));
  return all;
}

std::size_t wrong(const std::vector<double>& given, const std::vector<double>& got) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < given.size(); ++i) count += got[i] != truly_rounded(given[i]) ? 1 : 0;
  return count;
}

std::vector<assess::Pair> pairs_of(const std::vector<double>& x) {
  std::vector<assess::Pair> pairs(x.size() / 6);
  for (std::size_t i = 0; i < x.size(); ++i)
    (i % 6 < 3 ? pairs[i / 6].wi : pairs[i / 6].wo)[i % 3] = x[i];
  return pairs;
}
std::vector<double> numbers_of(const std::vector<assess::Pair>& pairs) {
  std::vector<double> x;
  for (const auto& pair : pairs) {
    x.insert(x.end(), pair.wi.begin(), pair.wi.end());
    x.insert(x.end(), pair.wo.begin(), pair.wo.end());
  }
  return x;
}

// How many numbers are left unrounded, in all loops and sizes.
std::size_t wrong_in(const RoundingLoops& loops) {
  std::size_t count = 0;
  for (const std::size_t rows : kSizes) {
    for (std::size_t i = 0; i < std::size(kWidths); ++i) {
      const std::vector<double> given = numbers(rows * kWidths[i]);
      std::vector<double> in_place = given, to(given.size());
      loops.in_place[i](in_place.data(), rows);
      loops.copied[i](given.data(), to.data(), rows);
      count += wrong(given, in_place) + wrong(given, to);
    }
    const std::vector<double> given = numbers(6 * rows);
    auto pairs = pairs_of(given);
    loops.pairs(pairs.data(), rows);
    count += wrong(given, numbers_of(pairs));
  }
  return count;
}

TEST(Rounding, IsNotLostByTheCompiler) {
  EXPECT_EQ(wrong_in(plain::kRoundingLoops), 0U);
  EXPECT_EQ(wrong_in(baseline::kRoundingLoops), 0U);
  if (is_supported(Isa::avx2)) {
    EXPECT_EQ(wrong_in(avx2::kRoundingLoops), 0U);
  }
  if (is_supported(Isa::avx512)) {
    EXPECT_EQ(wrong_in(avx512::kRoundingLoops), 0U);
  }
}

TEST(Rounding, OfPairsOfEverySize) {
  for (const std::size_t size : kSizes) {
    const std::vector<double> given = numbers(6 * size);
    EXPECT_EQ(wrong(given, numbers_of(assess::rounded(pairs_of(given)))), 0U) << size;
  }
}

// The loops do show the fault where the guard is missing: in the compiler that has it.
TEST(Rounding, IsLostWithoutTheGuard) {
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12
  EXPECT_GT(wrong_in(unguarded::kRoundingLoops), 0U);
#else
  GTEST_SKIP() << "this compiler is not known to have the fault";
#endif
}

}  // namespace
}  // namespace gonio::testing
