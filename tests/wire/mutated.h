// Bytes with a few random edits.
#pragma once

#include <random>
#include <string>

namespace gonio::wire::testing {

inline std::string mutated(std::string bytes, std::mt19937& random) {
  const int edits = 1 + static_cast<int>(random() % 4);
  for (int i = 0; i < edits && !bytes.empty(); ++i) {
    const std::size_t at = random() % bytes.size();
    switch (random() % 5) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << (random() % 8)));
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.erase(at, 1 + random() % 8);
        break;
      default:
        bytes.insert(at, std::string(1 + random() % 8, static_cast<char>(random())));
    }
  }
  return bytes;
}

}  // namespace gonio::wire::testing
