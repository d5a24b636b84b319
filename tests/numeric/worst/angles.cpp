#include <numbers>

#include "numeric/worst/bounds.h"

namespace gonio::testing {
namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

using Angle = void (*Functions::*)(const double*, const double*, std::size_t, double*);

Worst worst_angle(std::span<const Isa> isas, Angle function) {
  Random random(46);
  std::vector<double> y(kCount), x(kCount), out(kCount);
  std::vector<long double> truth(kCount);
  return search(
      isas, kRandomBlocks,
      [&](std::size_t) {
        for (std::size_t i = 0; i < kCount; ++i) {
          const double large = random.uniform(1, 2), small = large * random.uniform(0, 1);
          y[i] = i % 2 == 0 ? large : small, x[i] = i % 2 == 0 ? small : large;
          truth[i] = std::atan2(static_cast<long double>(y[i]), static_cast<long double>(x[i]));
        }
      },
      [&](const Functions& use) { (use.*function)(y.data(), x.data(), kCount, out.data()); },
      [&](std::size_t i) { return std::abs(out[i] - truth[i]); });
}

// Sine and cosine of half turns, and of the whole ones that are made of them.
template <class Number>
struct Turns {
  std::vector<Number> x = std::vector<Number>(kCount), cos = x, sin = x;
  std::vector<long double> truth_cos = std::vector<long double>(kCount), truth_sin = truth_cos;

  void find_truth(bool whole) {
    for (std::size_t i = 0; i < kCount; ++i) {
      const long double angle = (static_cast<long double>(x[i]) - 0.5L) * kPi;
      const long double c = std::cos(angle), s = std::sin(angle);
      truth_cos[i] = whole ? 2 * s * s - 1 : c;
      truth_sin[i] = whole ? -2 * s * c : s;
    }
  }
  [[nodiscard]] long double error(std::size_t i) const {
    return std::max(std::abs(cos[i] - truth_cos[i]), std::abs(sin[i] - truth_sin[i]));
  }
};

// All float32 numbers from 1/8 to 1.
Worst worst_of_floats(std::span<const Isa> isas, bool whole) {
  Turns<float> at;
  return search(
      isas, 3 * kBinade,
      [&](std::size_t block) {
        fill_floats(-3, block, 1, at.x);
        at.find_truth(whole);
      },
      [&](const Functions& use) {
        (whole ? use.turn_32 : use.half_turn_32)(at.x.data(), kCount, at.cos.data(), at.sin.data());
      },
      [&](std::size_t i) { return at.error(i); });
}

Worst worst_of_doubles(std::span<const Isa> isas, bool whole) {
  Random random(47);
  Turns<double> at;
  return search(
      isas, kRandomBlocks,
      [&](std::size_t) {
        for (double& x : at.x) x = random.uniform(0, 1);
        at.find_truth(whole);
      },
      [&](const Functions& use) {
        (whole ? use.turn_64 : use.half_turn_64)(at.x.data(), kCount, at.cos.data(), at.sin.data());
      },
      [&](std::size_t i) { return at.error(i); });
}

}  // namespace

Worst worst_quick_angle(std::span<const Isa> isas) {
  return worst_angle(isas, &Functions::angle_quick);
}
Worst worst_exact_angle(std::span<const Isa> isas) {
  return worst_angle(isas, &Functions::angle_exact);
}
Worst worst_half_turn(std::span<const Isa> isas) { return worst_of_floats(isas, false); }
Worst worst_turn(std::span<const Isa> isas) { return worst_of_floats(isas, true); }
Worst worst_exact_half_turn(std::span<const Isa> isas) { return worst_of_doubles(isas, false); }
Worst worst_exact_turn(std::span<const Isa> isas) { return worst_of_doubles(isas, true); }

}  // namespace gonio::testing
