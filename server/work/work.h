// What is asked of the compute threads: checked, cut into tiles that any of them may run, and made
// into an answer. Evaluation, Sampling and Integration are the kinds.
//
// Thread safety: different tiles may run at once; take_answer() of the kinds after all of them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "gonio/base/result.h"
#include "gonio/engine/evaluate.h"
#include "gonio/engine/isa.h"
#include "gonio/v1/evaluate.pb.h"
#include "gonio/v1/sample.pb.h"
#include "server/materials/prepared_material.h"
#include "server/work/memory_budget.h"

namespace gonio::server {

// Room for everything in an answer that is not in its arrays: numbers, the error bound's note, tags
// and lengths.
inline constexpr std::size_t kHeadBytes = 4096;

// How a request wants to be computed.
struct Settings {
  Precision precision = Precision::fast;
  Isa isa = Isa::baseline;

  [[nodiscard]] std::size_t number_bytes() const {
    return precision == Precision::fast ? sizeof(float) : sizeof(double);
  }
};

// UNSPECIFIED is the best of the processor. Errors: what the enum does not have, or the processor.
Result<Isa> choose_isa(v1::InstructionSet asked);

// `Head`: a request's message. Errors: what the enums do not have, or the processor.
template <class Head>
Result<Settings> settings_of(const Head& head);

class Work {
 public:
  virtual ~Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  [[nodiscard]] std::size_t items() const { return items_; }  // pairs or samples
  [[nodiscard]] virtual std::size_t tiles() const { return (items_ + kTilePairs - 1) / kTilePairs; }
  // Memory held until the answer is sent.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  // Can be computed at once by whoever read it: handing it to another thread would cost more.
  [[nodiscard]] bool is_small() const;

  virtual void run_tile(std::size_t tile) = 0;
  void run_all();
  // What bytes() has been charged to; whoever takes the answer takes it too, until that is sent.
  void keep(MemoryBudget::Charge charge) { charge_ = std::move(charge); }
  MemoryBudget::Charge take_charge() { return std::move(charge_); }
  [[nodiscard]] double kernel_seconds() const;

 protected:
  Work(PreparedMaterial material, const Settings& settings, bool needs_sampler)
      : material_(std::move(material)), settings_(settings), needs_sampler_(needs_sampler) {}

  [[nodiscard]] const Material& material() const { return material_.material(); }
  [[nodiscard]] const Sampler& sampler() const { return material_.sampler(); }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] std::size_t channels() const {
    return static_cast<std::size_t>(material().channels());
  }

  // Runs `body` on the clock; what it returns are flags.
  template <class Body>
  void run_timed(const Body& body);
  [[nodiscard]] bool any_flagged() const { return any_flags_ != 0; }
  void write(v1::Report& report) const;
  // What is to be computed, and the memory that it and its request hold.
  void set_size(std::size_t items, std::size_t bytes) {
    items_ = items;
    bytes_ = bytes;
  }

 private:
  static constexpr std::size_t kSmallValues = 3 * 1024;

  void add_time(std::int64_t nanoseconds) { kernel_nanoseconds_ += nanoseconds; }
  static std::int64_t now();

  std::size_t items_ = 0, bytes_ = 0;
  PreparedMaterial material_;
  Settings settings_;
  bool needs_sampler_;
  MemoryBudget::Charge charge_;
  std::atomic<std::uint8_t> any_flags_{0};
  std::atomic<std::int64_t> kernel_nanoseconds_{0};
};

template <class Body>
void Work::run_timed(const Body& body) {
  const std::int64_t start = now();
  const std::uint8_t flags = body();
  add_time(now() - start);
  any_flags_ |= flags;
}

}  // namespace gonio::server
