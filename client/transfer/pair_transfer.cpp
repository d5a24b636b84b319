#include "client/transfer/pair_transfer.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

namespace gonio::client {
namespace {

constexpr std::size_t kDirection = 3;  // numbers in one

template <class In>
OutgoingChunk empty_chunk(std::uint64_t first, std::size_t pairs) {
  const std::size_t bytes = pairs * kDirection * sizeof(In);
  return {
      first, pairs,
      wire::PairSlices{allocate_slice(bytes), allocate_slice(bytes), std::is_same_v<In, double>}};
}

}  // namespace

template <class In>
Result<std::optional<OutgoingChunk>> ArraySource<In>::next(std::size_t limit) {
  const std::size_t left = wi_.size() / kDirection - first_;
  const std::size_t pairs = std::min(left, limit);
  if (pairs == 0) return std::optional<OutgoingChunk>{};
  const std::size_t bytes = pairs * kDirection * sizeof(In);
  OutgoingChunk chunk{first_, pairs,
                      wire::PairSlices{slice_of(&wi_[first_ * kDirection], bytes, loan_),
                                       slice_of(&wo_[first_ * kDirection], bytes, loan_),
                                       std::is_same_v<In, double>}};
  first_ += pairs;
  return std::optional(std::move(chunk));
}

template <class In>
Result<std::optional<OutgoingChunk>> CallbackSource<In>::next(std::size_t limit) {
  OutgoingChunk chunk = empty_chunk<In>(first_, limit);
  auto given = fill_(std::span(writable<In>(chunk.wi()), limit * kDirection),
                     std::span(writable<In>(chunk.wo()), limit * kDirection));
  if (!given) return given.error();
  if (*given > limit) {
    return bad_value("the number of pairs that the source returned", std::to_string(*given),
                     "at most " + std::to_string(limit));
  }
  if (*given == 0) return std::optional<OutgoingChunk>{};
  chunk.pairs = *given;
  for (auto& one : chunk.arrays.arrays) {
    one.data = one.data.sub(0, *given * kDirection * sizeof(In));
  }
  first_ += *given;
  return std::optional(std::move(chunk));
}

template <class Out>
Outcome ArrayReceiver<Out>::accept(const OutgoingChunk& chunk, const Answer& answer,
                                   Report& report) {
  const std::size_t channels = answer.channels;
  if (values_.size() != pairs_ * channels) {
    return bad_value("the length of values", std::to_string(values_.size()),
                     std::to_string(pairs_) + " pairs x " + std::to_string(channels) +
                         " channels of this material = " + std::to_string(pairs_ * channels));
  }
  copy_numbers(answer, answer.values, &values_[chunk.first * channels]);
  if (!pdf_.empty()) copy_numbers(answer, answer.pdf, &pdf_[chunk.first]);
  if (!flags_.empty()) {
    take_flags(answer, flags_.subspan(chunk.first, chunk.pairs), report);
  } else if (answer.flags.count != 0) {
    scratch_.resize(chunk.pairs);
    take_flags(answer, scratch_, report);
  }
  return Ok{};
}

template <class In, class Out>
Outcome SinkReceiver<In, Out>::accept(const OutgoingChunk& chunk, const Answer& answer,
                                      Report& report) {
  values_.resize(answer.values.count);
  copy_numbers(answer, answer.values, values_.data());
  pdf_.resize(answer.pdf.count);
  copy_numbers(answer, answer.pdf, pdf_.data());
  flags_.resize(chunk.pairs);
  take_flags(answer, flags_, report);
  Chunk<In, Out> result;
  result.first = chunk.first;
  result.pairs = chunk.pairs;
  result.channels = static_cast<int>(answer.channels);
  if (chunk.wi().size() > 0) {
    result.wi = {writable<In>(chunk.wi()), chunk.pairs * kDirection};
    result.wo = {writable<In>(chunk.wo()), chunk.pairs * kDirection};
  }
  result.values = values_;
  result.pdf = pdf_;
  result.flags = flags_;
  return sink_(result);
}

template class ArraySource<float>;
template class ArraySource<double>;
template class CallbackSource<float>;
template class CallbackSource<double>;
template class ArrayReceiver<float>;
template class ArrayReceiver<double>;
template class SinkReceiver<float, float>;
template class SinkReceiver<float, double>;
template class SinkReceiver<double, double>;

}  // namespace gonio::client
