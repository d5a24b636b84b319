#include "gonio/engine/isa.h"

#include <array>

#include "kernels/kernel.h"
#include "kernels/sampling_kernel.h"

namespace gonio {
namespace {

constexpr std::array kIsas{Isa::baseline, Isa::avx2, Isa::avx512};

std::size_t count_supported() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") == 0 || __builtin_cpu_supports("fma") == 0) return 1;
  const bool avx512 =
      __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
      __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0;
  return avx512 ? 3 : 2;
}

}  // namespace

std::span<const Isa> supported_isas() {
  static const std::size_t count = count_supported();
  return {kIsas.data(), count};
}

Isa best_isa() { return supported_isas().back(); }

bool is_supported(Isa isa) { return static_cast<std::size_t>(isa) < supported_isas().size(); }

std::string_view name_of(Isa isa) {
  constexpr std::array<std::string_view, 3> kNames{"baseline", "avx2", "avx512"};
  return kNames[static_cast<std::size_t>(isa)];
}

std::string_view name_of(Precision precision) {
  return precision == Precision::fast ? "fast" : "reference";
}

const KernelTable& kernels(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return avx512::kKernels;
    case Isa::avx2:
      return avx2::kKernels;
    case Isa::baseline:
      break;
  }
  return baseline::kKernels;
}

const SamplingTable& sampling_kernels(Isa isa) {
  switch (isa) {
    case Isa::avx512:
      return avx512::kSampling;
    case Isa::avx2:
      return avx2::kSampling;
    case Isa::baseline:
      break;
  }
  return baseline::kSampling;
}

}  // namespace gonio
