// A material in naive arithmetic (naive.h), for comparison. Thread safety: immutable.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gonio/engine/material.h"

namespace gonio::assess {

template <class T>
class NaiveMaterial {
 public:
  using Direction = std::array<T, 3>;

  // None for a material with a part that has no naive form, such as a table.
  static std::optional<NaiveMaterial> of(const Material& material);

  // f of every channel, unchecked: also NaN and infinity.
  void evaluate(const Direction& wi, const Direction& wo, std::span<T> f) const;

 private:
  struct Lobe;
  NaiveMaterial() = default;
  [[nodiscard]] Direction seen(const Direction& w) const;
  std::vector<std::shared_ptr<const Lobe>> lobes_;
  T cos_ = 1, sin_ = 0;  // of the material's rotation
};

extern template class NaiveMaterial<float>;
extern template class NaiveMaterial<double>;

}  // namespace gonio::assess
