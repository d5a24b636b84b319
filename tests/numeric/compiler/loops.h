// Loops over rows of numbers that are rounded to float32 and widened again, as the product has
// them: what GCC 12's vectoriser of straight-line code gets wrong (CMakeLists.txt at the top).
#pragma once

#include <cstddef>

#include "assess/subject.h"

namespace gonio::testing {

// The widths of rows that are tried: 1, and those that a packet does not divide.
inline constexpr std::size_t kWidths[] = {1, 2, 3, 4, 5, 6};

struct RoundingLoops {
  // Rounds `rows` rows of kWidths[i] numbers in place, and into other memory.
  void (*in_place[6])(double* numbers, std::size_t rows);
  void (*copied[6])(const double* from, double* to, std::size_t rows);
  // The directions of pairs, as places.cpp has them.
  void (*pairs)(assess::Pair* pairs, std::size_t count);
};

}  // namespace gonio::testing

namespace gonio::baseline {
extern const testing::RoundingLoops kRoundingLoops;
}
namespace gonio::avx2 {
extern const testing::RoundingLoops kRoundingLoops;
}
namespace gonio::avx512 {
extern const testing::RoundingLoops kRoundingLoops;
}
// With the flags of other targets of the product, and without the guard.
namespace gonio::plain {
extern const testing::RoundingLoops kRoundingLoops;
}
namespace gonio::unguarded {
extern const testing::RoundingLoops kRoundingLoops;
}
