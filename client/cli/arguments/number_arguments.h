// The arguments that say how many samples are drawn, and by which numbers. Thread safety: plain
// values.
#pragma once

#include <cstdint>
#include <string>

#include "gonio/base/result.h"
#include "gonio/client/sampling.h"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs
class App;
}

namespace gonio::cli {

// Samples of one command, all wi together.
inline constexpr std::uint64_t kMostSamples = 1'000'000'000;

struct NumberArguments {
  std::int64_t count = 0;  // of each wi; signed, so that -1 is refused as what it is
  std::uint64_t seed = 0;
  std::string sequence = "random";

  [[nodiscard]] std::uint64_t per_wi() const { return static_cast<std::uint64_t>(count); }
  [[nodiscard]] client::NumberSource source() const;
};

// Adds --count, --seed and --sequence.
void add_number_options(CLI::App& command, NumberArguments& arguments);

// Errors: fewer than `least`, or more than kMostSamples of `directions`.
Outcome check_count(const NumberArguments& arguments, std::uint64_t least,
                    std::uint64_t directions);

}  // namespace gonio::cli
