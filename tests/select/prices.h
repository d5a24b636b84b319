// Prices for all parts that do not depend on the machine, for tests of what else selections say.
#pragma once

#include <map>
#include <string>

#include "select/candidates.h"

namespace gonio::testing {

inline std::map<std::string, double, std::less<>> prices_of_all_parts() {
  std::map<std::string, double, std::less<>> prices;
  for (const select::Candidate& candidate : select::candidates({}, 3, 2)) {
    for (const std::string& part : candidate.parts)
      prices[part] = part == "lambertian" ? 1 : 2 + 0.1 * static_cast<double>(part.size());
  }
  return prices;
}

}  // namespace gonio::testing
