// What the client library takes and gives: precision, instruction sets, flags, the report of an
// evaluation.
//
// Thread safety: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "gonio/base/stated_bound.h"

namespace gonio::client {

enum class Precision : std::uint8_t {
  fast,       // float32 in and out
  reference,  // float64 throughout
};

enum class InstructionSet : std::uint8_t {
  best,  // in a request: the best one that the server's processor has
  baseline,
  avx2,
  avx512,
};

std::string_view name_of(Precision precision);  // "fast", "reference"
std::string_view name_of(InstructionSet set);   // "auto", "baseline", "avx2", "avx512"
std::optional<InstructionSet> instruction_set_of(std::string_view name);  // the inverse

// Bits of a pair's flag byte. A flagged pair has the value 0 in every channel, unless its only flag
// is `hole`; 0 means nothing to report.
namespace flag {
enum Bit : std::uint8_t {
  not_unit = 1,                 // a length differs from 1 by more than 1e-3
  not_finite = 2,               // a component is NaN or infinite
  zero = 4,                     // a direction is (0,0,0)
  incident_below_horizon = 8,   // wi is at or below the horizon
  outgoing_below_horizon = 16,  // wo is at or below the horizon
  outside_data = 32,            // a measured material has no valid data there
  bad_number = 64,              // of a sample: a number to draw it by is outside [0, 1)
  hole = 128,                   // part of the cells that the value is from hold no measurement
};
}  // namespace flag

inline constexpr std::size_t kFlagBits = 8;
// What bit number `bit` (0 to kFlagBits - 1) means, in words: "not unit", ..., "outside the data",
// ...
std::string_view flag_meaning(std::size_t bit);

using ErrorBound = gonio::StatedBound;

// What an evaluation, or the drawing of samples, cost and what it is worth.
struct Report {
  std::uint64_t pairs = 0;  // or samples
  int channels = 0;
  double kernel_seconds = 0;  // spent in the BRDF kernels, summed over the server's threads
  InstructionSet instruction_set = InstructionSet::best;
  Precision precision = Precision::fast;
  ErrorBound error_bound;
  std::uint64_t lost = 0;  // samples that fell to or below the horizon
  // Pairs that have the value 0 for any flag, lost samples too; those that met a hole and keep
  // their value are in `flagged_by` alone.
  std::uint64_t flagged = 0;
  std::array<std::uint64_t, kFlagBits>
      flagged_by{};  // pairs with this bit; a pair may have several
  int retries = 0;   // times that a call, a stream or refused chunks were sent again after a pause
};

}  // namespace gonio::client
