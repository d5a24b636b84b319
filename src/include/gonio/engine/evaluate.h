// Evaluates a material for a batch of direction pairs.
//
// Frame: normal (0,0,1), tangents u = (1,0,0) and v = (0,1,0); wi points to the light and wo to the
// viewer, both away from the surface. Values are f(wi, wo) in 1/sr, without a cosine. Directions
// may be off unit length by 1e-3 and are corrected; what cannot be evaluated gets the value 0 in
// every channel and a flag, and touches nothing else (a flag `hole` alone leaves the value).
// Results depend on nothing but the pair, the material, the precision and the instruction set: not
// on the batch it is in, nor on threads, tiles or layout (bit for bit).
#pragma once

#include <cstddef>
#include <cstdint>

#include "gonio/base/result.h"
#include "gonio/engine/isa.h"
#include "gonio/engine/material.h"

namespace gonio {

class ThreadPool;

// Bits of a pair's flag byte (the wire uses the same).
namespace flag {
inline constexpr std::uint8_t not_unit = 1;
inline constexpr std::uint8_t not_finite = 2;
inline constexpr std::uint8_t zero = 4;
inline constexpr std::uint8_t incident_below_horizon = 8;
inline constexpr std::uint8_t outgoing_below_horizon = 16;
inline constexpr std::uint8_t outside_data = 32;
inline constexpr std::uint8_t bad_number = 64;  // of a sample: a number outside [0, 1)
// A measured material's value is taken from cells of which some are holes (MeasuredTable::holes):
// not measured, or masked. The value stands. Samples do not have it.
inline constexpr std::uint8_t hole = 128;
}  // namespace flag

// A view of directions: component c of direction i is at c[i * stride].
template <class T>
struct Directions {
  const T* x = nullptr;
  const T* y = nullptr;
  const T* z = nullptr;
  std::ptrdiff_t stride = 1;

  static Directions interleaved(const T* xyz) { return {xyz, xyz + 1, xyz + 2, 3}; }
  static Directions separate(const T* x, const T* y, const T* z) { return {x, y, z, 1}; }
};

// A view of results: channel c of pair i is at data[i * pair_stride + c * channel_stride].
template <class T>
struct Values {
  T* data = nullptr;
  std::ptrdiff_t pair_stride = 1;
  std::ptrdiff_t channel_stride = 0;

  static Values interleaved(T* data, int channels) { return {data, channels, 1}; }
  static Values planar(T* data, std::size_t pairs) {
    return {data, 1, static_cast<std::ptrdiff_t>(pairs)};
  }
};

// In/Out: float/float is Precision::fast; float/double and double/double are Precision::reference.
template <class In, class Out>
struct Batch {
  Directions<In> wi, wo;
  std::size_t count = 0;
  Values<Out> values;
  std::uint8_t* flags = nullptr;  // one byte a pair, or null
};

// Pairs that one thread should evaluate at a time, at most: they and their results fit its caches.
inline constexpr std::size_t kTilePairs = 4096;

// Evaluates the whole batch on the calling thread. `values` has room for material.channels() of
// every pair and overlaps no direction; `isa` must be supported (undefined otherwise). Returns the
// bitwise or of all flags.
std::uint8_t evaluate(const Material& material, const Batch<float, float>& batch, Isa isa);
std::uint8_t evaluate(const Material& material, const Batch<float, double>& batch, Isa isa);
std::uint8_t evaluate(const Material& material, const Batch<double, double>& batch, Isa isa);

// The same on the calling thread and `pool` together; returns when all is done.
std::uint8_t evaluate(const Material& material, const Batch<float, float>& batch, Isa isa,
                      ThreadPool& pool);
std::uint8_t evaluate(const Material& material, const Batch<float, double>& batch, Isa isa,
                      ThreadPool& pool);
std::uint8_t evaluate(const Material& material, const Batch<double, double>& batch, Isa isa,
                      ThreadPool& pool);

}  // namespace gonio
