#include "fit/linear/array_kernels.h"
#include "gonio/engine/isa.h"

namespace gonio::fit {

const ArrayKernels& array_kernels() {
  switch (best_isa()) {
    case Isa::avx512:
      return avx512::kArrayKernels;
    case Isa::avx2:
      return avx2::kArrayKernels;
    case Isa::baseline:
      break;
  }
  return baseline::kArrayKernels;
}

}  // namespace gonio::fit
