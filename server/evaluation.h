// One batch on its way: checked, cut into tiles that any thread may run, and made into an answer.
//
// Thread safety: different tiles may run at once; take_answer() after all of them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "base/result.h"
#include "engine/evaluate.h"
#include "engine/material.h"
#include "server/direction_source.h"
#include "server/memory_budget.h"
#include "wire/codec.h"

namespace gonio {

class Evaluation {
 public:
  // Checks the request (but for its material, given ready) and allocates the answer. Errors name
  // field, value and what is allowed; an answer larger than `max_answer_bytes` is refused before
  // anything is allocated.
  static Result<std::shared_ptr<Evaluation>> prepare(const wire::Request& request,
                                                     Material material,
                                                     std::size_t max_answer_bytes);

  [[nodiscard]] std::size_t pairs() const { return pairs_; }
  [[nodiscard]] std::size_t tiles() const { return (pairs_ + kTilePairs - 1) / kTilePairs; }
  // Memory held until the answer is sent.
  [[nodiscard]] std::size_t bytes() const {
    return values_.size() + flags_.size() + request_bytes_;
  }
  // Small enough to be computed at once by whoever read it: handing it to another thread would cost
  // more.
  [[nodiscard]] bool is_small() const {
    return pairs_ * static_cast<std::size_t>(channels_) <= kSmallValues;
  }

  void run_tile(std::size_t tile);
  void run_all();
  wire::ResponseParts take_answer();
  // What bytes() has been charged to; whoever takes the answer takes it too, until that is sent.
  void keep(MemoryBudget::Charge charge) { charge_ = std::move(charge); }
  MemoryBudget::Charge take_charge() { return std::move(charge_); }
  [[nodiscard]] double kernel_seconds() const;

 private:
  static constexpr std::size_t kSmallValues = 3 * 1024;

  Evaluation(DirectionSource source, Material material)
      : source_(std::move(source)), material_(std::move(material)) {}
  Outcome allocate(std::size_t max_answer_bytes);
  template <class In, class Out>
  void evaluate_tile(std::size_t first, std::size_t count);

  DirectionSource source_;
  Material material_;
  Precision precision_ = Precision::fast;
  Isa isa_ = Isa::baseline;
  int channels_ = 0;
  std::size_t pairs_ = 0;
  std::size_t request_bytes_ = 0;
  grpc::Slice values_, flags_;
  MemoryBudget::Charge charge_;
  void* value_data_ = nullptr;
  std::uint8_t* flag_data_ = nullptr;
  std::atomic<std::uint8_t> any_flags_{0};
  std::atomic<std::int64_t> kernel_nanoseconds_{0};
};

}  // namespace gonio
