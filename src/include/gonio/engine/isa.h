// Precision and instruction set: the two runtime choices of every evaluation.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace gonio {

enum class Precision : std::uint8_t {
  fast,       // float32 in and out; cancellations avoided or carried in float64 inside
  reference,  // float64 throughout
};

enum class Isa : std::uint8_t { baseline, avx2, avx512 };

std::span<const Isa> supported_isas();  // what this processor can run, the best last
Isa best_isa();
bool is_supported(Isa isa);
std::string_view name_of(Isa isa);              // "baseline", "avx2", "avx512"
std::string_view name_of(Precision precision);  // "fast", "reference"

}  // namespace gonio
