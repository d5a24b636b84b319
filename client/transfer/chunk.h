// A chunk: the directions of one message to the server. A transfer takes chunks from a source, and
// gives their answers to a receiver. Internal to the client library.
//
// Thread safety: used by the calling thread only.
#pragma once

#include <grpcpp/support/slice.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "client/messages/answer.h"
#include "client/rpc/loan.h"
#include "gonio/base/result.h"
#include "gonio/client/client.h"
#include "wire/codec.h"

namespace gonio::client {

// A run of pairs or samples as it is sent; it may be sent again. Copies share the arrays.
struct OutgoingChunk {
  std::uint64_t first = 0;
  std::size_t pairs = 0;
  wire::RequestArrays arrays = {};
  // Serialised fields of this chunk alone: a grid, a run of samples.
  std::string head = {};

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
  // Takes an answer whose lengths fit the chunk. Counts of flags go into `report`.
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

}  // namespace gonio::client
