// The kernels of measured tables in one instruction set: compiled three times, with GONIO_ISA
// naming the namespace.
#include "kernels/sampling_kernel.h"
#include "measured/merl/eval.h"
#include "measured/merl/sample.h"

namespace gonio::GONIO_ISA {

template <bool kLinear>
constexpr PartKernels merl_kernels() {
  constexpr EvalKernels kEval{&look_up<Fast, kLinear, float>, &look_up<Reference, kLinear, float>,
                              &look_up<Reference, kLinear, double>};
  return {kEval,
          {&look_up_with_density<Fast, kLinear, float>,
           &look_up_with_density<Reference, kLinear, float>,
           &look_up_with_density<Reference, kLinear, double>, &draw_from_table<float>,
           &draw_from_table<double>}};
}

extern const KernelArray<2> kMerlKernels;  // NOLINT(readability-redundant-declaration): linkage
const KernelArray<2> kMerlKernels{{merl_kernels<true>(), merl_kernels<false>()}};

}  // namespace gonio::GONIO_ISA
