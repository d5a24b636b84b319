// The checked values of one lobe's parameters, by name, as a model's constants are prepared from
// them. S is double, or a dual number where derivatives by the parameters are wanted. Every name of
// the model's table has a value.
#pragma once

#include <cassert>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

template <class S>
class ParameterValues {
 public:
  void set(std::string_view name, std::vector<S> numbers) {
    numbers_[std::string(name)] = std::move(numbers);
  }

  [[nodiscard]] const auto& all() const { return numbers_; }
  [[nodiscard]] S number(std::string_view name) const { return colour(name, 0); }
  // One number stands for all channels.
  [[nodiscard]] S colour(std::string_view name, int channel) const {
    const auto found = numbers_.find(name);
    assert(found != numbers_.end());
    const auto& values = found->second;
    return values.size() == 1 ? values[0] : values[static_cast<std::size_t>(channel)];
  }

 private:
  std::map<std::string, std::vector<S>, std::less<>> numbers_;
};

}  // namespace gonio
