// The floating-point environment of the kernels.
#pragma once

#include <xmmintrin.h>

namespace gonio {

// Results too small for a normal number become 0 while this lives: a lobe's tail is full of them,
// and each would cost a hundred cycles. Denormal inputs keep their value.
class FlushToZero {
 public:
  // Not what the caller has set: rounding and denormal inputs decide bits, too.
  FlushToZero() : before_(_mm_getcsr()) { _mm_setcsr(_MM_MASK_MASK | _MM_FLUSH_ZERO_ON); }
  ~FlushToZero() { _mm_setcsr(before_); }
  FlushToZero(const FlushToZero&) = delete;
  FlushToZero& operator=(const FlushToZero&) = delete;

 private:
  unsigned before_;
};

}  // namespace gonio
