// What a chart was measured on, and with. Thread safety: a function without state.
#pragma once

#include <string>
#include <vector>

namespace gonio::chart {

struct Machine {
  std::string processor;                      // its name, as Linux has it
  unsigned cores = 0;                         // that this process may run on
  std::vector<std::string> instruction_sets;  // that gonio has kernels for and it runs
  std::string gonio;                          // version
  std::string compiler;                       // "GCC 12.2.0"
  std::string system;                         // "Linux 6.1.0"
};

Machine this_machine();

}  // namespace gonio::chart
