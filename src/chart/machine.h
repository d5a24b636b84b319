// The machine and the build that a chart was measured with. Thread safety: a function without
// state.
#pragma once

#include <string>
#include <vector>

namespace gonio::chart {

struct Machine {
  std::string processor;  // its name in /proc/cpuinfo
  unsigned cores = 0;     // cores that this process may run on
  std::vector<std::string>
      instruction_sets;  // those that gonio has kernels for and the processor supports
  std::string gonio;     // version
  std::string compiler;  // "GCC 12.2.0"
  std::string system;    // "Linux 6.1.0"
};

Machine this_machine();

}  // namespace gonio::chart
