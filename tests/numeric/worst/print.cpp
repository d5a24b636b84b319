// Prints the worst errors that are found on this machine: a line for each bound and instruction
// set, for proofs/prove.py.
#include <cstdio>

#include "numeric/worst/bounds.h"

// Of all bounds, or of those named.
int main(int argc, char** argv) {
  const auto isas = gonio::supported_isas();
  const std::span<char*> names(argv + 1, argv + argc);
  for (const gonio::testing::Bound& bound : gonio::testing::bounds()) {
    const auto is_bound = [&](const char* name) { return bound.name == name; };
    if (!names.empty() && std::none_of(names.begin(), names.end(), is_bound)) continue;
    const gonio::testing::Worst worst = bound.search(isas);
    for (std::size_t k = 0; k < isas.size(); ++k) {
      std::printf("%s %s %.3Lg%s\n", bound.name.data(),
                  std::string(gonio::name_of(isas[k])).c_str(), worst[k],
                  bound.by_estimate ? " by estimate" : "");
    }
    std::fflush(stdout);
  }
}
