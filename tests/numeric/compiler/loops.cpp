// Compiled several times, with GONIO_ISA naming the namespace.
#include "numeric/compiler/loops.h"

namespace gonio::GONIO_ISA {
namespace {

template <std::size_t kWidth>
void in_place(double* numbers, std::size_t rows) {
  auto* row = reinterpret_cast<double(*)[kWidth]>(numbers);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t c = 0; c < kWidth; ++c)
      row[i][c] = static_cast<double>(static_cast<float>(row[i][c]));
  }
}

template <std::size_t kWidth>
void copied(const double* from, double* to, std::size_t rows) {
  const auto* in = reinterpret_cast<const double(*)[kWidth]>(from);
  auto* out = reinterpret_cast<double(*)[kWidth]>(to);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t c = 0; c < kWidth; ++c)
      out[i][c] = static_cast<double>(static_cast<float>(in[i][c]));
  }
}

void pairs(assess::Pair* pairs, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (auto* w : {&pairs[i].wi, &pairs[i].wo}) {
      for (double& x : *w) x = static_cast<double>(static_cast<float>(x));
    }
  }
}

}  // namespace

extern const testing::RoundingLoops kRoundingLoops;
const testing::RoundingLoops kRoundingLoops{
    {in_place<1>, in_place<2>, in_place<3>, in_place<4>, in_place<5>, in_place<6>},
    {copied<1>, copied<2>, copied<3>, copied<4>, copied<5>, copied<6>},
    pairs};

}  // namespace gonio::GONIO_ISA
