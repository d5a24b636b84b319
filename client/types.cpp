#include "gonio/client/types.h"

namespace gonio::client {
namespace {

constexpr std::array<std::string_view, 4> kInstructionSets = {"auto", "baseline", "avx2", "avx512"};
constexpr std::array<std::string_view, kFlagBits> kFlagMeanings = {"not unit",
                                                                   "not finite",
                                                                   "zero",
                                                                   "wi below the horizon",
                                                                   "wo below the horizon",
                                                                   "outside the data",
                                                                   "a number outside [0, 1)",
                                                                   "a hole of the table"};

}  // namespace

std::string_view name_of(Precision precision) {
  return precision == Precision::fast ? "fast" : "reference";
}

std::string_view name_of(InstructionSet set) {
  return kInstructionSets[static_cast<std::size_t>(set)];
}

std::optional<InstructionSet> instruction_set_of(std::string_view name) {
  for (std::size_t i = 0; i < kInstructionSets.size(); ++i) {
    if (kInstructionSets[i] == name) return static_cast<InstructionSet>(i);
  }
  return std::nullopt;
}

std::string_view flag_meaning(std::size_t bit) { return kFlagMeanings.at(bit); }

}  // namespace gonio::client
