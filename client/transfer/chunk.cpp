#include "client/transfer/chunk.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>

namespace gonio::client {

grpc::Slice allocate_slice(std::size_t bytes) {
  void* memory = std::malloc(std::max<std::size_t>(bytes, 1));
  if (memory == nullptr) throw std::bad_alloc();
  return {memory, bytes, std::free};
}

grpc::Slice slice_of(const void* data, std::size_t bytes, Loan* loan) {
  constexpr std::size_t kWorthLending = 16384;  // below, a copy costs less than the bookkeeping
  if (loan != nullptr && bytes >= kWorthLending) return loan->lend(data, bytes);
  return {data, bytes};
}

void take_flags(const Answer& answer, std::span<std::uint8_t> flags, Report& report) {
  if (answer.flags.count == 0) {
    std::fill(flags.begin(), flags.end(), std::uint8_t{0});
    return;
  }
  answer.bytes.copy(answer.flags.offset, answer.flags.count, flags.data());
  std::array<std::uint64_t, 256> histogram{};
  for (const std::uint8_t flag : flags) ++histogram[flag];
  for (std::size_t value = 1; value < histogram.size(); ++value) {
    if (value != flag::hole) report.flagged += histogram[value];
    for (std::size_t bit = 0; bit < kFlagBits; ++bit) {
      if ((value >> bit) & 1U) report.flagged_by[bit] += histogram[value];
    }
  }
}

}  // namespace gonio::client
