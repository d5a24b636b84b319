// Where the directions of one batch come from: arrays in the request's bytes, or a grid that is
// expanded on the way.
//
// Thread safety: immutable; read() may run in many threads at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "gonio/base/result.h"
#include "gonio/engine/grid.h"
#include "gonio/engine/isa.h"
#include "wire/codec.h"

namespace gonio::server {

class DirectionSource {
 public:
  // Errors: no directions, arrays of wrong lengths, float64 pairs for PRECISION_FAST, a grid
  // without axes or with both kinds, a run outside the grid. Fields are named as in the request
  // ("pairs.wi").
  static Result<DirectionSource> create(const wire::Request& request, Precision precision);

  [[nodiscard]] std::uint64_t size() const { return size_; }  // pairs
  [[nodiscard]] bool is_grid() const { return grid_.has_value(); }
  [[nodiscard]] bool is_f64() const { return is_f64_; }  // whether they are read as doubles

  // Writes pairs first ... first + count - 1, interleaved xyz. float where !is_f64(), double
  // otherwise.
  template <class T>
  void read(std::size_t first, std::size_t count, T* wi, T* wo) const {
    if (grid_) return grid_->expand(grid_first_ + first, count, wi, wo);
    const std::size_t from = first * 3 * sizeof(T), bytes = count * 3 * sizeof(T);
    bytes_.copy(wi_offset_ + from, bytes, wi);
    bytes_.copy(wo_offset_ + from, bytes, wo);
  }

 private:
  Outcome set_pairs(const wire::Request& request);
  Outcome set_grid(const v1::Grid& grid);

  wire::SliceBytes bytes_;
  std::size_t wi_offset_ = 0, wo_offset_ = 0;
  std::optional<Grid> grid_;
  std::uint64_t grid_first_ = 0;
  std::uint64_t size_ = 0;
  bool is_f64_ = false;
};

}  // namespace gonio::server
