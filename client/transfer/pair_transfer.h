// The two ends of a transfer of pairs of directions: sources of chunks, and receivers of values.
// Internal to the client library.
//
// Thread safety: used by the calling thread only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/rpc/loan.h"
#include "client/transfer/chunk.h"
#include "gonio/base/result.h"
#include "gonio/client/client.h"
#include "gonio/v1/directions.pb.h"

namespace gonio::client {

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
