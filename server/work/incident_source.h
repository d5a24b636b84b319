// The directions wi of a request that samples, whose numbers lie in the request's bytes in float32
// or float64.
//
// Thread safety: immutable; read() may run in many threads at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "gonio/base/result.h"
#include "gonio/engine/isa.h"
#include "gonio/engine/random_numbers.h"
#include "wire/codec.h"

namespace gonio::server {

// An array of numbers in a request.
class NumberArray {
 public:
  // The one of the two that is given. Errors: both, or float64 for Precision::fast. `field`: the
  // name of the float32 one.
  static Result<NumberArray> create(const std::string& field, const wire::SliceBytes& bytes,
                                    const wire::Array& f32, const wire::Array& f64,
                                    Precision precision);

  [[nodiscard]] std::size_t size() const { return array_.count; }
  // Numbers first ... first + count - 1. T: float for Precision::fast, else double.
  template <class T>
  void read(std::size_t first, std::size_t count, T* to) const;

 private:
  wire::SliceBytes bytes_;
  wire::Array array_;
  bool is_f64_ = false;
};

// What Sample and Integrate have in common.
struct IncidentSource {
  NumberArray wi;
  std::uint64_t per_wi = 1;
  NumberSource numbers;
  std::uint64_t first_wi = 0;  // the number of the first wi

  // Errors: those of NumberArray; wi of a wrong length; too few samples of each wi; more samples
  // than 64 bits can number; an unknown sequence.
  template <class Request>
  static Result<IncidentSource> create(const Request& request, Precision precision,
                                       std::uint64_t least_per_wi);

  [[nodiscard]] std::size_t directions() const { return wi.size() / 3; }
  [[nodiscard]] std::uint64_t samples() const { return directions() * per_wi; }
};

}  // namespace gonio::server
