#include <numbers>

#include "numeric/worst/bounds.h"

namespace gonio::testing {
namespace {

// An argument and an amplitude, and how wrong the result of both is.
struct Case {
  double x = 0;
  float amplitude = 1;
  long double error = 0;  // with its sign
};

// Errors of amplitude * 2^x for the kCount pairs.
void evaluate(const Functions& use, std::vector<Case>& cases) {
  std::vector<float> amplitude(kCount), out(kCount);
  std::vector<double> x(kCount);
  for (std::size_t i = 0; i < kCount; ++i) amplitude[i] = cases[i].amplitude, x[i] = cases[i].x;
  use.times_exp2_quick(amplitude.data(), x.data(), kCount, out.data());
  for (std::size_t i = 0; i < kCount; ++i) {
    const long double truth = amplitude[i] * std::exp2(static_cast<long double>(x[i]));
    cases[i].error = out[i] / truth - 1;
  }
}

bool larger(const Case& a, const Case& b) { return std::abs(a.error) > std::abs(b.error); }

// All 2^23 reduced arguments, each moved as far as the reduction allows, the way that adds to the
// error; the worst of them.
std::vector<Case> worst_arguments(const Functions& use, std::size_t count) {
  std::vector<Case> worst, cases(kCount);
  for (std::size_t block = 0; block < kBinade; ++block) {
    for (const double side : {-1, 1}) {
      for (std::size_t i = 0; i < kCount; ++i) {
        const double whole = static_cast<double>(block * kCount + i) * 0x1p-23;
        cases[i] = {std::min(whole + side * 0x0.ffffp-24, 1.0) - 1, 1, 0};
      }
      evaluate(use, cases);
      std::partial_sort(cases.begin(), cases.begin() + 64, cases.end(), larger);
      worst.insert(worst.end(), cases.begin(), cases.begin() + 64);
    }
  }
  std::sort(worst.begin(), worst.end(), larger);
  worst.resize(count);
  return worst;
}

// The worst arguments, each with many amplitudes: the last product is rounded, too.
long double worst_over_amplitudes(const Functions& use) {
  constexpr std::size_t kArguments = 256;
  Random random(41);
  std::vector<Case> cases(kCount);
  long double worst = 0;
  const auto arguments = worst_arguments(use, kArguments);
  for (std::size_t round = 0; round < 16; ++round) {
    for (std::size_t i = 0; i < kCount; ++i)
      cases[i] = {arguments[i % kArguments].x, static_cast<float>(random.uniform(1, 2)), 0};
    evaluate(use, cases);
    for (const Case& at : cases) keep_worse(worst, std::abs(at.error));
  }
  return worst;
}

}  // namespace

Worst worst_times_exp2(std::span<const Isa> isas) {
  Worst worst;
  for (const Isa isa : isas) {
    const FlushToZero flush;
    worst.push_back(worst_over_amplitudes(functions(isa)));
  }
  return worst;
}

Worst worst_exact_times_exp2(std::span<const Isa> isas) {
  Random random(42);
  std::vector<double> x(kCount), amplitude(kCount), out(kCount);
  std::vector<long double> truth(kCount);
  return search(
      isas, kRandomBlocks,
      [&](std::size_t) {
        for (std::size_t i = 0; i < kCount; ++i) {
          x[i] = random.uniform(-1, 0) - (i % 2 == 0 ? 0 : std::floor(random.uniform(0, 990)));
          amplitude[i] = random.uniform(1, 2);
          truth[i] = amplitude[i] * std::exp2(static_cast<long double>(x[i]));
        }
      },
      [&](const Functions& use) {
        use.times_exp2_exact(amplitude.data(), x.data(), kCount, out.data());
      },
      [&](std::size_t i) { return relative_error(out[i], truth[i]); });
}

namespace {

// x from -1/4 on over four binades, all float32 numbers.
constexpr int kLeast = -2;
constexpr std::size_t kBinades = 4;

Worst worst_of_floats(std::span<const Isa> isas, bool one_minus) {
  std::vector<float> x(kCount), power(kCount), rest(kCount);
  std::vector<long double> truth(kCount);
  return search(
      isas, kBinades * kBinade,
      [&](std::size_t block) {
        fill_floats(kLeast, block, -1, x);
        for (std::size_t i = 0; i < kCount; ++i) {
          const long double at = x[i];
          truth[i] = one_minus ? -std::expm1(at * std::numbers::ln2_v<long double>) : std::exp2(at);
        }
      },
      [&](const Functions& use) { use.exp2_32(x.data(), kCount, power.data(), rest.data()); },
      [&](std::size_t i) { return relative_error(one_minus ? rest[i] : power[i], truth[i]); });
}

Worst worst_of_doubles(std::span<const Isa> isas, bool one_minus) {
  Random random(43);
  std::vector<double> x(kCount), power(kCount), rest(kCount);
  std::vector<long double> truth(kCount);
  return search(
      isas, kRandomBlocks,
      [&](std::size_t) {
        for (std::size_t i = 0; i < kCount; ++i) {
          x[i] = -(i % 4 == 0 ? random.logarithmic(-50, 9) : random.uniform(0, 2));
          const long double at = x[i];
          truth[i] = one_minus ? -std::expm1(at * std::numbers::ln2_v<long double>) : std::exp2(at);
        }
      },
      [&](const Functions& use) { use.exp2_64(x.data(), kCount, power.data(), rest.data()); },
      [&](std::size_t i) { return relative_error(one_minus ? rest[i] : power[i], truth[i]); });
}

}  // namespace

Worst worst_exp2(std::span<const Isa> isas) { return worst_of_floats(isas, false); }
Worst worst_one_minus_exp2(std::span<const Isa> isas) { return worst_of_floats(isas, true); }
Worst worst_exact_exp2(std::span<const Isa> isas) { return worst_of_doubles(isas, false); }
Worst worst_exact_one_minus_exp2(std::span<const Isa> isas) { return worst_of_doubles(isas, true); }

}  // namespace gonio::testing
