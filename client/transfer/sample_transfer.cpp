#include "client/transfer/sample_transfer.h"

#include <algorithm>
#include <string>
#include <type_traits>

namespace gonio::client {
namespace {

constexpr std::size_t kDirection = 3;  // numbers in one; as many draw a sample

// The part of a request that says which samples of its wi are wanted.
std::string run_of(std::uint64_t first_wi, std::uint64_t first, std::size_t samples) {
  gonio::v1::SampleRequest run;
  run.set_first_wi(first_wi);
  run.set_first(first);
  run.set_count(samples);
  return run.SerializeAsString();
}

template <class T>
void resize_and_copy(const Answer& answer, const wire::Array& array, std::vector<T>& to) {
  to.resize(array.count);
  copy_numbers(answer, array, to.data());
}

}  // namespace

template <class T>
Result<std::optional<OutgoingChunk>> SampleArraySource<T>::next(std::size_t limit) {
  const auto samples = static_cast<std::size_t>(std::min<std::uint64_t>(left_, limit));
  if (samples == 0) return std::optional<OutgoingChunk>{};
  const std::uint64_t first_wi = next_ / batch_.per_wi;
  const std::uint64_t last_wi = (next_ + samples - 1) / batch_.per_wi;
  const auto directions = static_cast<std::size_t>(last_wi - first_wi + 1);
  wire::SampleSlices slices;
  slices.is_f64 = std::is_same_v<T, double>;
  slices.wi =
      slice_of(&batch_.wi[first_wi * kDirection], directions * kDirection * sizeof(T), loan_);
  if (!batch_.xi.empty()) {
    slices.xi = slice_of(&batch_.xi[(next_ - batch_.first) * kDirection],
                         samples * kDirection * sizeof(T), loan_);
  }
  OutgoingChunk chunk{next_, samples, slices, run_of(first_wi, next_ % batch_.per_wi, samples)};
  next_ += samples;
  left_ -= samples;
  return std::optional(std::move(chunk));
}

// As many directions as a chunk has samples for, or one.
template <class T>
Outcome SampleCallbackSource<T>::refill(std::size_t limit) {
  first_wi_ += wi_.size() / kDirection;
  const auto most = static_cast<std::size_t>(std::max<std::uint64_t>(limit / per_wi_, 1));
  wi_.resize(most * kDirection);
  auto given = fill_(std::span(wi_));
  if (!given) return given.error();
  if (*given > most) {
    return bad_value("the number of directions that the source returned", std::to_string(*given),
                     "at most " + std::to_string(most));
  }
  wi_.resize(*given * kDirection);
  next_ = 0;
  end_ = *given * per_wi_;
  return Ok{};
}

template <class T>
Result<std::optional<OutgoingChunk>> SampleCallbackSource<T>::next(std::size_t limit) {
  if (next_ == end_) {
    if (auto filled = refill(limit); !filled) return filled.error();
    if (next_ == end_) return std::optional<OutgoingChunk>{};
  }
  const auto samples = static_cast<std::size_t>(std::min<std::uint64_t>(end_ - next_, limit));
  const grpc::Slice wi = allocate_slice(wi_.size() * sizeof(T));  // the sink reads it as numbers
  std::copy(wi_.begin(), wi_.end(), writable<T>(wi));
  OutgoingChunk chunk{first_wi_ * per_wi_ + next_, samples,
                      wire::SampleSlices{wi, {}, std::is_same_v<T, double>},
                      run_of(first_wi_, next_, samples)};
  next_ += samples;
  return std::optional(std::move(chunk));
}

template <class T>
Outcome SampleArrayReceiver<T>::accept(const OutgoingChunk& chunk, const Answer& answer,
                                       Report& report) {
  const std::size_t samples = results_.pdf.size();
  if (results_.weights.size() != samples * answer.channels) {
    return bad_value(
        "the length of weights", std::to_string(results_.weights.size()),
        std::to_string(samples) + " samples x " + std::to_string(answer.channels) +
            " channels of this material = " + std::to_string(samples * answer.channels));
  }
  const auto at = static_cast<std::size_t>(chunk.first - first_);
  copy_numbers(answer, answer.wo, &results_.wo[at * kDirection]);
  copy_numbers(answer, answer.pdf, &results_.pdf[at]);
  copy_numbers(answer, answer.values, &results_.weights[at * answer.channels]);
  if (!results_.flags.empty()) {
    take_flags(answer, results_.flags.subspan(at, chunk.pairs), report);
  } else if (answer.flags.count != 0) {
    scratch_.resize(chunk.pairs);
    take_flags(answer, scratch_, report);
  }
  return Ok{};
}

template <class T>
Outcome SampleSinkReceiver<T>::accept(const OutgoingChunk& chunk, const Answer& answer,
                                      Report& report) {
  resize_and_copy(answer, answer.wo, wo_);
  resize_and_copy(answer, answer.pdf, pdf_);
  resize_and_copy(answer, answer.values, weights_);
  flags_.resize(chunk.pairs);
  take_flags(answer, flags_, report);
  SampleChunk<T> result;
  result.first = chunk.first;
  result.samples = chunk.pairs;
  result.per_wi = per_wi_;
  result.channels = static_cast<int>(answer.channels);
  result.wi = {writable<T>(chunk.wi()), chunk.wi().size() / sizeof(T)};
  result.wo = wo_;
  result.pdf = pdf_;
  result.weights = weights_;
  result.flags = flags_;
  return sink_(result);
}

template class SampleArraySource<float>;
template class SampleArraySource<double>;
template class SampleCallbackSource<float>;
template class SampleCallbackSource<double>;
template class SampleArrayReceiver<float>;
template class SampleArrayReceiver<double>;
template class SampleSinkReceiver<float>;
template class SampleSinkReceiver<double>;

}  // namespace gonio::client
