// Each function that samples are drawn by holds the error that numeric/errors.h states, on every
// instruction set that this machine has.
#include <gtest/gtest.h>

#include <numbers>

#include "engine/material/flush_to_zero.h"
#include "numeric/arrays.h"
#include "numeric/errors.h"

namespace gonio::testing {
namespace {

template <class T>
struct Stated;
template <>
struct Stated<float> {
  static constexpr double kLog2 = errors::kLog2OneMinusError, kExp2 = errors::kExp2Error,
                          kOneMinusExp2 = errors::kOneMinusExp2Error, kTurn = errors::kTurnError;
  static constexpr double kMostHalvings = 100;
};
template <>
struct Stated<double> {
  static constexpr double kLog2 = errors::kExactLog2OneMinusError, kExp2 = errors::kExactExp2Error,
                          kOneMinusExp2 = errors::kExactOneMinusExp2Error,
                          kTurn = errors::kExactTurnError;
  static constexpr double kMostHalvings = 1000;
};

void log2_one_minus(const Functions& use, const std::vector<float>& x, std::vector<float>& out) {
  use.log2_one_minus_32(x.data(), x.size(), out.data());
}
void log2_one_minus(const Functions& use, const std::vector<double>& x, std::vector<double>& out) {
  use.log2_one_minus_64(x.data(), x.size(), out.data());
}
void exp2_of(const Functions& use, const std::vector<float>& x, std::vector<float>& power,
             std::vector<float>& one_minus) {
  use.exp2_32(x.data(), x.size(), power.data(), one_minus.data());
}
void exp2_of(const Functions& use, const std::vector<double>& x, std::vector<double>& power,
             std::vector<double>& one_minus) {
  use.exp2_64(x.data(), x.size(), power.data(), one_minus.data());
}
void turn(const Functions& use, const std::vector<float>& x, std::vector<float>& cos,
          std::vector<float>& sin) {
  use.turn_32(x.data(), x.size(), cos.data(), sin.data());
}
void turn(const Functions& use, const std::vector<double>& x, std::vector<double>& cos,
          std::vector<double>& sin) {
  use.turn_64(x.data(), x.size(), cos.data(), sin.data());
}

template <class T>
class WarpOf : public ::testing::Test {
 protected:
  // Numbers in [0, 1): half of them near 0, a quarter near 1.
  static std::vector<T> numbers() {
    const auto small = powers(-40, 0, 11), other = powers(-30, 0, 12);
    std::vector<T> x(kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
      x[i] = static_cast<T>(i % 4 == 0 ? 1 - other[i] : i % 4 == 1 ? 2 * other[i] - 1 : small[i]);
      x[i] = std::abs(x[i]);
      if (!(x[i] < 1)) x[i] = 1 - std::numeric_limits<T>::epsilon();
    }
    x[0] = 0;
    return x;
  }

  std::vector<T> out = std::vector<T>(kCount), other = std::vector<T>(kCount);
};
using Types = ::testing::Types<float, double>;
TYPED_TEST_SUITE(WarpOf, Types);

TYPED_TEST(WarpOf, LogarithmOfTheRest) {
  auto x = this->numbers();
  const auto truth = [&](std::size_t i) {
    return std::log1p(-static_cast<long double>(x[i])) / std::numbers::ln2_v<long double>;
  };
  for (const Isa isa : supported_isas()) {
    SCOPED_TRACE(name_of(isa));
    log2_one_minus(functions(isa), x, this->out);
    EXPECT_EQ(this->out[0], 0);
    this->out[0] = static_cast<TypeParam>(truth(1)), x[0] = x[1];
    EXPECT_LE(worst_relative<TypeParam>(this->out, truth), Stated<TypeParam>::kLog2);
    x[0] = 0;
    const std::vector<TypeParam> ones(kCount, 1);
    log2_one_minus(functions(isa), ones, this->out);
    EXPECT_LT(this->out[0], -120);
    EXPECT_TRUE(std::isfinite(this->out[0]));
  }
}

TYPED_TEST(WarpOf, PowerOfTwoAndTheRest) {
  using S = Stated<TypeParam>;
  const auto sizes = powers(-60, std::log2(S::kMostHalvings), 13);
  std::vector<TypeParam> x(kCount);
  for (std::size_t i = 0; i < kCount; ++i) x[i] = static_cast<TypeParam>(-sizes[i]);
  for (const Isa isa : supported_isas()) {
    SCOPED_TRACE(name_of(isa));
    const FlushToZero flush;
    exp2_of(functions(isa), x, this->out, this->other);
    const auto power = [&](std::size_t i) { return std::exp2(static_cast<long double>(x[i])); };
    const auto rest = [&](std::size_t i) {
      return -std::expm1(static_cast<long double>(x[i]) * std::numbers::ln2_v<long double>);
    };
    EXPECT_LE(worst_relative<TypeParam>(this->out, power), S::kExp2);
    EXPECT_LE(worst_relative<TypeParam>(this->other, rest), S::kOneMinusExp2);
  }
}

TYPED_TEST(WarpOf, PowerOfTwoAtItsEnds) {
  using S = Stated<TypeParam>;
  std::vector<TypeParam> x(kCount, std::numeric_limits<TypeParam>::lowest());
  x[0] = 0, x[1] = static_cast<TypeParam>(-2 * S::kMostHalvings), x[2] = -0.5, x[3] = -1;
  for (const Isa isa : supported_isas()) {
    SCOPED_TRACE(name_of(isa));
    exp2_of(functions(isa), x, this->out, this->other);
    EXPECT_EQ(this->out[0], 1);
    EXPECT_EQ(this->other[0], 0);
    EXPECT_EQ(this->out[3], static_cast<TypeParam>(0.5));
    for (const std::size_t i : {1, 4, 5}) {
      EXPECT_GE(this->out[i], 0);
      EXPECT_LE(this->out[i], std::exp2(-S::kMostHalvings));
      EXPECT_EQ(this->other[i], 1);
    }
  }
}

TYPED_TEST(WarpOf, Turn) {
  const auto x = this->numbers();
  for (const Isa isa : supported_isas()) {
    SCOPED_TRACE(name_of(isa));
    turn(functions(isa), x, this->out, this->other);
    long double worst = 0;
    for (std::size_t i = 0; i < kCount; ++i) {
      const long double angle = 2 * std::numbers::pi_v<long double> * x[i];
      worst = std::max({worst, std::abs(this->out[i] - std::cos(angle)),
                        std::abs(this->other[i] - std::sin(angle))});
      ASSERT_FALSE(std::isnan(this->out[i]) || std::isnan(this->other[i]));
    }
    EXPECT_LE(worst, Stated<TypeParam>::kTurn);
  }
}

}  // namespace
}  // namespace gonio::testing
