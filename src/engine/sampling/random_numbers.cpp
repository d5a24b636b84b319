#include "gonio/engine/random_numbers.h"

#include "kernels/sampling_kernel.h"

namespace gonio {

void random_numbers(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi,
                    std::size_t count, float* const (&xi)[3]) {
  sampling_kernels(best_isa()).numbers32(source, first, per_wi, count, xi);
}
void random_numbers(const NumberSource& source, std::uint64_t first, std::uint64_t per_wi,
                    std::size_t count, double* const (&xi)[3]) {
  sampling_kernels(best_isa()).numbers64(source, first, per_wi, count, xi);
}

}  // namespace gonio
