#include "chart/front.h"

#include <algorithm>
#include <cmath>

namespace gonio::chart {
namespace {

bool is_beaten(const Tradeoff& a, const Tradeoff& by) {
  return by.cost <= a.cost && by.error <= a.error && (by.cost < a.cost || by.error < a.error);
}

}  // namespace

std::vector<bool> on_front(std::span<const Tradeoff> choices) {
  std::vector<bool> front;
  front.reserve(choices.size());
  for (const Tradeoff& choice : choices) {
    const bool known = !std::isnan(choice.cost) && !std::isnan(choice.error);
    front.push_back(known && std::ranges::none_of(choices, [&](const Tradeoff& other) {
                      return is_beaten(choice, other);
                    }));
  }
  return front;
}

}  // namespace gonio::chart
