// Where chunks of directions come from, and where their answers go: the two ends of an evaluation.
//
// Internal to the client library. Used on the calling thread only.
#pragma once

#include <grpcpp/support/slice.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "client/rpc/answer.h"
#include "client/rpc/loan.h"
#include "gonio/base/result.h"
#include "gonio/client/client.h"
#include "wire/codec.h"

namespace gonio::client {

// A run of pairs or samples, as it is sent (and sent again, if need be). Copies share the arrays.
struct OutgoingChunk {
  std::uint64_t first = 0;
  std::size_t pairs = 0;
  wire::RequestArrays arrays = {};
  std::string head = {};  // what this chunk alone has, serialised: a grid, a run of samples

  [[nodiscard]] const grpc::Slice& wi() const { return arrays.arrays[0].data; }
  [[nodiscard]] const grpc::Slice& wo() const { return arrays.arrays[1].data; }
};

class ChunkSource {
 public:
  virtual ~ChunkSource() = default;
  // The next pairs, at most `limit`; none at the end.
  virtual Result<std::optional<OutgoingChunk>> next(std::size_t limit) = 0;
};

class ChunkReceiver {
 public:
  virtual ~ChunkReceiver() = default;
  // Whether the answers must come in the order of the pairs.
  [[nodiscard]] virtual bool ordered() const = 0;
  // Takes an answer whose lengths fit the chunk. `flagged` is where the counts of flags go.
  virtual Outcome accept(const OutgoingChunk& chunk, const Answer& answer, Report& report) = 0;
};

// A slice of its own memory, aligned for any number. gRPC's own allocation puts small slices inside
// the handle, where nothing is aligned.
grpc::Slice allocate_slice(std::size_t bytes);

template <class T>
T* writable(const grpc::Slice& slice) {
  return reinterpret_cast<T*>(const_cast<std::uint8_t*>(slice.begin()));
}

// A slice of the caller's array: lent where there is a `loan`, else a copy.
grpc::Slice slice_of(const void* data, std::size_t bytes, Loan* loan);

// Copies an array of an answer.
template <class T>
void copy_numbers(const Answer& answer, const wire::Array& array, T* to) {
  answer.bytes.copy(array.offset, array.count * sizeof(T), to);
}

// Copies the answer's flags (all clear where it has none) and counts them.
void take_flags(const Answer& answer, std::span<std::uint8_t> flags, Report& report);

// From the caller's arrays: lent where there is a `loan`, else copied.
template <class In>
class ArraySource final : public ChunkSource {
 public:
  ArraySource(std::span<const In> wi, std::span<const In> wo, Loan* loan)
      : wi_(wi), wo_(wo), loan_(loan) {}
  Result<std::optional<OutgoingChunk>> next(std::size_t limit) override;

 private:
  std::span<const In> wi_, wo_;
  Loan* loan_;
  std::uint64_t first_ = 0;
};

template <class In>
class CallbackSource final : public ChunkSource {
 public:
  explicit CallbackSource(const PairSource<In>& fill) : fill_(fill) {}
  Result<std::optional<OutgoingChunk>> next(std::size_t limit) override;

 private:
  const PairSource<In>& fill_;
  std::uint64_t first_ = 0;
};

// A grid, run by run. Only the part of the axes that a run touches is sent with it: a long axis
// costs no more than once.
class GridSource final : public ChunkSource {
 public:
  // `grid` is checked, and outlives the source.
  explicit GridSource(const Grid& grid);
  Result<std::optional<OutgoingChunk>> next(std::size_t limit) override;

 private:
  using Axis = google::protobuf::RepeatedField<double>;
  struct NamedAxis {
    const std::vector<double>* angles;
    Axis* (gonio::v1::Grid::*field)();
  };

  std::vector<NamedAxis> axes_;  // the last the fastest
  std::uint64_t size_;
  std::uint64_t first_ = 0;
};

// Into the caller's arrays, in any order.
template <class Out>
class ArrayReceiver final : public ChunkReceiver {
 public:
  // `pdf` is empty where none was asked for.
  ArrayReceiver(std::span<Out> values, std::span<Out> pdf, std::span<std::uint8_t> flags,
                std::size_t pairs)
      : values_(values), pdf_(pdf), flags_(flags), pairs_(pairs) {}
  [[nodiscard]] bool ordered() const override { return false; }
  Outcome accept(const OutgoingChunk& chunk, const Answer& answer, Report& report) override;

 private:
  std::span<Out> values_, pdf_;
  std::span<std::uint8_t> flags_;
  std::size_t pairs_;
  std::vector<std::uint8_t> scratch_;  // flags to count that the caller does not want
};

// To the caller's function, in order.
template <class In, class Out>
class SinkReceiver final : public ChunkReceiver {
 public:
  explicit SinkReceiver(const ChunkSink<In, Out>& sink) : sink_(sink) {}
  [[nodiscard]] bool ordered() const override { return true; }
  Outcome accept(const OutgoingChunk& chunk, const Answer& answer, Report& report) override;

 private:
  const ChunkSink<In, Out>& sink_;
  std::vector<Out> values_, pdf_;
  std::vector<std::uint8_t> flags_;
};

}  // namespace gonio::client
