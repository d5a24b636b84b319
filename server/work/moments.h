// Mean and spread of numbers that come in runs: Chan, Golub & LeVeque 1983, "Algorithms for
// Computing the Sample Variance", equation 2.1. Merging the same runs in the same order gives the
// same bits. Thread safety: plain values.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gonio::server {

struct Moments {
  double mean = 0;
  double squares = 0;  // of the distances from the mean, summed

  // Of values[0], values[stride], ..., `count` > 0 of them.
  template <class T>
  static Moments of(const T* values, std::size_t stride, std::size_t count) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < count; ++i) sum += static_cast<double>(values[i * stride]);
    const double mean = sum / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double distance = static_cast<double>(values[i * stride]) - mean;
      squares += distance * distance;
    }
    return {mean, squares};
  }

  // Adds those of `more` > 0 numbers to those of `count`.
  void merge(std::uint64_t count, const Moments& other, std::uint64_t more) {
    const auto a = static_cast<double>(count), b = static_cast<double>(more);
    const double apart = other.mean - mean;
    mean += apart * (b / (a + b));
    squares += other.squares + apart * apart * (a * b / (a + b));
  }
};

}  // namespace gonio::server
