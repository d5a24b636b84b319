// What the kernels of a measured table read.
#pragma once

#include <cstdint>

namespace gonio {
class TableSampling;
}

namespace gonio::merl {

struct Constants {
  const float* table;  // MeasuredTable::data()
  // A bit a cell: whether a lookup from it meets a hole (HoleMap); null if none does.
  const std::uint64_t* holes = nullptr;
};

// What its draws and densities read.
struct Drawn {
  Constants constants;
  const TableSampling* sampling;
};

// TableSampling's functions on plain arrays: kernels of all instruction sets call them.
void draw(const TableSampling& table, const double (&wi)[3], const double (&xi)[3],
          double (&wo)[3]);
double density(const TableSampling& table, const double (&wi)[3], const double (&wo)[3]);

}  // namespace gonio::merl
