// Compiled three times, with GONIO_ISA naming the namespace.
#include "fit/linear/array_kernels.h"

#include "numeric/elementary.h"

namespace gonio::GONIO_ISA {
namespace {

using fit::Objective;
using D = Double<Exactness::exact>;
constexpr std::size_t kWidth = raw::kWidth;

// k plus the series of 2 artanh(z), as in weighted_log2_1p; one division, and no weight.
GONIO_INLINE D log_1p(D x) {
  static constexpr double kSeries[] = {2,        2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9, 2.0 / 11,
                                       2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
  constexpr double kLog2 = 0.693147180559945309;
  const D a = D(1) + x;
  D power, k;
  nearest_power(a, D(1), power, k);
  const D z = (x - (power - D(1))) / (a + power);
  return k * kLog2 + z * polynomial(z * z, kSeries);
}

// With x = u 2^(3 q + j - 99), u in [2/3, 4/3) and j of 0, 1 and 2: u^(-1/3) by its Taylor series
// at 1, two steps of fourth order, and powers of 2.
GONIO_INLINE D cube_root(D x) {
  const D y = max(x, D(0x1p-99)) * 0x1p99;
  D power, k;
  nearest_power(y, D(1), power, k);
  const D u = scale(y, -k), away = u - D(1);
  D r = D(1) + away * (away * (2.0 / 9) - D(1.0 / 3));
  for (int step = 0; step < 2; ++step) {
    const D h = D(1) - u * r * r * r;
    static constexpr double kSeries[] = {1, 1.0 / 3, 2.0 / 9, 14.0 / 81};
    r = r * polynomial(h, kSeries);
  }
  const D q = round((k - D(1)) * (1.0 / 3)), j = k - q * 3;
  const D factor = select(j < D(0.5), D(1),
                          select(j < D(1.5), D(1.259921049894873165), D(1.587401051968199475)));
  return scale(u * r * r * factor, q - D(33));
}

// Of every whole packet and, padded with 0, of what is left.
template <D (*kFunction)(D)>
void map(const double* x, std::size_t count, double* to) {
  std::size_t i = 0;
  for (; i + kWidth <= count; i += kWidth) kFunction(D::load(x + i)).store(to + i);
  if (i == count) return;
  double rest[kWidth] = {};
  for (std::size_t j = i; j < count; ++j) rest[j - i] = x[j];
  kFunction(D::load(rest)).store(rest);
  for (std::size_t j = i; j < count; ++j) to[j] = rest[j - i];
}

// One packet of pairs at `i`; the weighted losses.
template <Objective kObjective>
GONIO_INLINE D packet(const fit::ResidualRun& run, std::size_t i) {
  const D cosine = D::load(run.cosine + i), weight = D::load(run.weight + i);
  const D measured = D::load(run.measured + i), f = D::load(run.f + i) * cosine;
  D residual = f - measured, slope = cosine;
  if constexpr (kObjective == Objective::log) {
    residual = log_1p(f) - measured;
    slope = cosine / (D(1) + f);
  } else if constexpr (kObjective == Objective::cbrt) {
    const D root = cube_root(f);
    residual = root - measured;
    slope = cosine / (root * root * 3);
  }
  residual.store(run.residual + i);
  slope.store(run.slope + i);
  if constexpr (kObjective == Objective::l1 || kObjective == Objective::log) {
    const D size = sqrt(residual * residual + D(run.smooth * run.smooth));
    sqrt(weight / max(size, D(1e-300))).store(run.root + i);
    return weight * size;
  } else if constexpr (kObjective == Objective::huber) {
    const D size = max(residual, -residual), inner = min(size, D(run.threshold));
    sqrt(weight * inner / max(size, D(1e-300))).store(run.root + i);
    return weight * inner * (size - inner * 0.5);
  } else {
    sqrt(weight).store(run.root + i);
    return weight * residual * residual * 0.5;
  }
}

// What is no whole packet goes through a copy that is padded with pairs of no weight.
template <Objective kObjective>
D rest(const fit::ResidualRun& run, std::size_t first) {
  double in[4][kWidth] = {}, out[3][kWidth];
  const double* from[4] = {run.f, run.cosine, run.weight, run.measured};
  double* to[3] = {run.residual, run.slope, run.root};
  for (int k = 0; k < 4; ++k) {
    for (std::size_t i = first; i < run.count; ++i) in[k][i - first] = from[k][i];
  }
  const fit::ResidualRun padded{kWidth,     in[0],         in[1],  in[2],  in[3],
                                run.smooth, run.threshold, out[0], out[1], out[2]};
  const D sum = packet<kObjective>(padded, 0);
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = first; i < run.count; ++i) to[k][i] = out[k][i - first];
  }
  return sum;
}

template <Objective kObjective>
double residuals(const fit::ResidualRun& run) {
  D sum = 0;
  std::size_t i = 0;
  for (; i + kWidth <= run.count; i += kWidth) sum = sum + packet<kObjective>(run, i);
  if (i < run.count) sum = sum + rest<kObjective>(run, i);
  double lanes[kWidth], total = 0;
  sum.store(lanes);
  for (const double lane : lanes) total += lane;
  return total;
}

}  // namespace

extern const fit::ArrayKernels kArrayKernels;  // NOLINT(readability-redundant-declaration): linkage
const fit::ArrayKernels kArrayKernels{
    &map<log_1p>,
    &map<cube_root>,
    {&residuals<Objective::l1>, &residuals<Objective::l2>, &residuals<Objective::huber>,
     &residuals<Objective::log>, &residuals<Objective::cbrt>}};

}  // namespace gonio::GONIO_ISA
