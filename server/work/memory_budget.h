// How much memory the requests and answers of all calls may hold together.
//
// Each stream keeps within a bound of its own, but a client may open any number of streams and read
// none of their answers. Thread safety: any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

namespace gonio::server {

class MemoryBudget {
 public:
  explicit MemoryBudget(std::size_t limit) : limit_(limit) {}

  [[nodiscard]] std::size_t limit() const { return limit_; }
  [[nodiscard]] std::size_t held() const { return held_; }

  // Gives its bytes back at its end, before which the budget must not end.
  struct GiveBack {
    std::size_t bytes = 0;
    void operator()(MemoryBudget* budget) const { budget->held_ -= bytes; }
  };
  using Charge = std::unique_ptr<MemoryBudget, GiveBack>;

  // Null if there is not so much left. What is alone always fits: waiting would not help it.
  [[nodiscard]] Charge take(std::size_t bytes) {
    std::size_t held = held_;
    do {
      if (held != 0 && (held >= limit_ || bytes > limit_ - held)) return nullptr;
    } while (!held_.compare_exchange_weak(held, held + bytes));
    return {this, GiveBack{bytes}};
  }

 private:
  std::size_t limit_;
  std::atomic<std::size_t> held_{0};
};

}  // namespace gonio::server
