// The two ends of a transfer of samples: sources of directions wi, and receivers of the samples.
// Internal to the client library.
//
// A chunk names its run by the number of its first wi, and the run within the samples of the wi
// that it carries. So each chunk can be sent, and sent again, without the others. Thread safety:
// used by the calling thread only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "client/transfer/chunk.h"
#include "gonio/client/client.h"

namespace gonio::client {

// Samples first ... first + count - 1 of the caller's arrays.
template <class T>
class SampleArraySource final : public ChunkSource {
 public:
  SampleArraySource(const SampleBatch<T>& batch, std::uint64_t count, Loan* loan)
      : batch_(batch), left_(count), next_(batch.first), loan_(loan) {}
  Result<std::optional<OutgoingChunk>> next(std::size_t limit) override;

 private:
  const SampleBatch<T>& batch_;
  std::uint64_t left_, next_;  // samples
  Loan* loan_;
};

// per_wi samples of each of the caller's directions, as they come.
template <class T>
class SampleCallbackSource final : public ChunkSource {
 public:
  SampleCallbackSource(const DirectionSource<T>& fill, std::uint64_t per_wi)
      : fill_(fill), per_wi_(per_wi) {}
  Result<std::optional<OutgoingChunk>> next(std::size_t limit) override;

 private:
  Outcome refill(std::size_t limit);

  const DirectionSource<T>& fill_;
  std::uint64_t per_wi_;
  std::uint64_t first_wi_ = 0;        // the number of the first of wi_
  std::vector<T> wi_;                 // whose samples are not all sent
  std::uint64_t next_ = 0, end_ = 0;  // samples, from the first of wi_ on
};

// Into the caller's arrays, in any order.
template <class T>
class SampleArrayReceiver final : public ChunkReceiver {
 public:
  SampleArrayReceiver(const Samples<T>& results, std::uint64_t first)
      : results_(results), first_(first) {}
  [[nodiscard]] bool ordered() const override { return false; }
  Outcome accept(const OutgoingChunk& chunk, const Answer& answer, Report& report) override;

 private:
  const Samples<T>& results_;
  std::uint64_t first_;
  std::vector<std::uint8_t> scratch_;  // flags to count that the caller does not want
};

// To the caller's function, in order.
template <class T>
class SampleSinkReceiver final : public ChunkReceiver {
 public:
  SampleSinkReceiver(const SampleSink<T>& sink, std::uint64_t per_wi)
      : sink_(sink), per_wi_(per_wi) {}
  [[nodiscard]] bool ordered() const override { return true; }
  Outcome accept(const OutgoingChunk& chunk, const Answer& answer, Report& report) override;

 private:
  const SampleSink<T>& sink_;
  std::uint64_t per_wi_;
  std::vector<T> wo_, pdf_, weights_;
  std::vector<std::uint8_t> flags_;
};

}  // namespace gonio::client
