#include "numeric/cancelling.h"
#include "numeric/worst/bounds.h"

namespace gonio::testing {

Worst worst_quick_division(std::span<const Isa> isas) {
  Random random(48);
  std::vector<double> a(kCount), b(kCount), out(kCount);
  return search(
      isas, kRandomBlocks,
      [&](std::size_t) {
        for (std::size_t i = 0; i < kCount; ++i)
          a[i] = random.logarithmic(-300, 300), b[i] = random.logarithmic(-300, 300);
      },
      [&](const Functions& use) { use.divide_quick(a.data(), b.data(), kCount, out.data()); },
      [&](std::size_t i) { return relative_error(out[i], static_cast<long double>(a[i]) / b[i]); });
}

Worst worst_inverse_length(std::span<const Isa> isas) {
  Random random(49);
  std::vector<double> e(kCount), out(kCount);
  return search(
      isas, kRandomBlocks,
      [&](std::size_t) {
        for (double& x : e) x = random.uniform(-2.1e-3, 2.1e-3);
      },
      [&](const Functions& use) { use.inverse_length_64(e.data(), kCount, out.data()); },
      [&](std::size_t i) {
        return relative_error(out[i], 1 / std::sqrt(1 + static_cast<long double>(e[i])));
      });
}

// All float32 numbers of two binades of either sign, cut off at 2.1e-3.
Worst worst_float_inverse_length(std::span<const Isa> isas) {
  std::vector<float> e(kCount), out(kCount);
  return search(
      isas, 4 * kBinade,
      [&](std::size_t block) {
        fill_floats(-10, block / 2, block % 2 == 0 ? -1.0F : 1.0F, e);
        for (float& x : e) x = std::clamp(x, -2.1e-3F, 2.1e-3F);
      },
      [&](const Functions& use) { use.inverse_length_32(e.data(), kCount, out.data()); },
      [&](std::size_t i) {
        return relative_error(out[i], 1 / std::sqrt(1 + static_cast<long double>(e[i])));
      });
}

// Of float64, and of float32 numbers with the quicker form.
Worst worst_exact_dot(std::span<const Isa> isas) {
  std::vector<double> out(kCount);
  VectorPairs pairs;
  const auto worst = [&](bool wide) {
    return search(
        isas, 4,
        [&](std::size_t block) {
          const auto seed = static_cast<unsigned>(50 + block);
          pairs =
              wide ? cancelling_pairs<double>(kCount, seed) : cancelling_pairs<float>(kCount, seed);
        },
        [&](const Functions& use) {
          (wide ? use.dot_exact : use.dot_quick)(pairs.a.data(), pairs.b.data(), kCount,
                                                 out.data());
        },
        [&](std::size_t i) { return relative_error(out[i], pairs.truth[i]); });
  };
  Worst wide = worst(true);
  const Worst narrow = worst(false);
  for (std::size_t k = 0; k < wide.size(); ++k) wide[k] = std::max(wide[k], narrow[k]);
  return wide;
}

}  // namespace gonio::testing
