#include <numbers>

#include "numeric/worst/bounds.h"

namespace gonio::testing {
namespace {

constexpr long double kLog2 = std::numbers::ln2_v<long double>;

using Weighted = void (*Functions::*)(const double*, const double*, const double*, std::size_t,
                                      double*);

// Most of the quotients s/c where the sum of k and the series cancels: below 1.
Worst worst_weighted(std::span<const Isa> isas, Weighted function) {
  Random random(44);
  std::vector<double> w(kCount), s(kCount), c(kCount), out(kCount);
  std::vector<long double> truth(kCount);
  return search(
      isas, kRandomBlocks / 4,
      [&](std::size_t) {
        for (std::size_t i = 0; i < kCount; ++i) {
          w[i] = random.uniform(1, 2), c[i] = random.uniform(1, 2);
          s[i] = c[i] * (i % 4 == 0   ? random.logarithmic(-120, 40)
                         : i % 4 == 1 ? random.uniform(0, 2)
                                      : random.uniform(0.33, 0.4));
          const long double ratio = static_cast<long double>(s[i]) / c[i];
          truth[i] = w[i] / static_cast<long double>(s[i]) * (std::log1p(ratio) / kLog2);
        }
      },
      [&](const Functions& use) {
        (use.*function)(w.data(), s.data(), c.data(), kCount, out.data());
      },
      [&](std::size_t i) { return relative_error(out[i], truth[i]); });
}

// Arguments, and how wrong the result of them is.
struct Case {
  double w = 1, s = 1, c = 1;
  long double error = 0;
};

void evaluate(const Functions& use, Weighted function, std::vector<Case>& cases) {
  std::vector<double> w(kCount), s(kCount), c(kCount), out(kCount);
  for (std::size_t i = 0; i < kCount; ++i) w[i] = cases[i].w, s[i] = cases[i].s, c[i] = cases[i].c;
  (use.*function)(w.data(), s.data(), c.data(), kCount, out.data());
  for (std::size_t i = 0; i < kCount; ++i) {
    const long double ratio = std::log1p(static_cast<long double>(s[i]) / c[i]) / kLog2;
    cases[i].error = relative_error(out[i], static_cast<long double>(w[i]) / s[i] * ratio);
  }
}

// A dozen roundings seldom all go the same way: from the worst cases to worse ones, by small steps.
// They begin where k is just 1, s = c/3: there the sum is the smallest beside its terms.
long double climb(const Functions& use, Weighted function) {
  constexpr std::size_t kKept = 64, kRounds = 48;
  Random random(51);
  std::vector<Case> kept(kKept, Case{1.5, 0.5, 1.5, 0}), cases(kCount);
  for (std::size_t round = 0; round < kRounds; ++round) {
    const auto moved = [&](double x) {
      return x * (1 + random.uniform(-1, 1) * random.logarithmic(-52, round < 4 ? -6 : -12));
    };
    for (std::size_t i = 0; i < kCount; ++i) {
      const Case& from = kept[i % kKept];
      cases[i] = {i / kKept % 4 == 0 ? random.uniform(1, 2) : from.w, moved(from.s), moved(from.c),
                  0};
    }
    evaluate(use, function, cases);
    cases.insert(cases.end(), kept.begin(), kept.end());
    const auto larger = [](const Case& a, const Case& b) { return a.error > b.error; };
    std::partial_sort(cases.begin(), cases.begin() + kKept, cases.end(), larger);
    kept.assign(cases.begin(), cases.begin() + kKept);
    cases.resize(kCount);
  }
  return kept.front().error;
}

Worst worst_of_both(std::span<const Isa> isas, Weighted function) {
  Worst worst = worst_weighted(isas, function);
  for (std::size_t k = 0; k < isas.size(); ++k) {
    const FlushToZero flush;
    worst[k] = std::max(worst[k], climb(functions(isas[k]), function));
  }
  return worst;
}

}  // namespace

Worst worst_quick_weighted_log2(std::span<const Isa> isas) {
  return worst_of_both(isas, &Functions::weighted_log2_quick);
}
Worst worst_exact_weighted_log2(std::span<const Isa> isas) {
  return worst_of_both(isas, &Functions::weighted_log2_exact);
}

// All float32 numbers from 1/16 to 1.
Worst worst_log2_one_minus(std::span<const Isa> isas) {
  std::vector<float> x(kCount), out(kCount);
  std::vector<long double> truth(kCount);
  return search(
      isas, 4 * kBinade,
      [&](std::size_t block) {
        fill_floats(-4, block, 1, x);
        for (std::size_t i = 0; i < kCount; ++i)
          truth[i] = std::log1p(-static_cast<long double>(x[i])) / kLog2;
      },
      [&](const Functions& use) { use.log2_one_minus_32(x.data(), kCount, out.data()); },
      [&](std::size_t i) { return relative_error(out[i], truth[i]); });
}

Worst worst_exact_log2_one_minus(std::span<const Isa> isas) {
  Random random(45);
  std::vector<double> x(kCount), out(kCount);
  std::vector<long double> truth(kCount);
  return search(
      isas, kRandomBlocks,
      [&](std::size_t) {
        for (std::size_t i = 0; i < kCount; ++i) {
          x[i] = i % 4 == 0   ? random.logarithmic(-60, 0)
                 : i % 4 == 1 ? 1 - random.logarithmic(-50, 0)
                              : random.uniform(0.25, 0.26);
          truth[i] = std::log1p(-static_cast<long double>(x[i])) / kLog2;
        }
      },
      [&](const Functions& use) { use.log2_one_minus_64(x.data(), kCount, out.data()); },
      [&](std::size_t i) { return relative_error(out[i], truth[i]); });
}

}  // namespace gonio::testing
