#include "server/work/sampling.h"

#include <algorithm>
#include <string>
#include <utility>

#include "server/calls/answer_buffer.h"
#include "server/work/tile_scratch.h"

namespace gonio::server {

Result<std::shared_ptr<Sampling>> Sampling::prepare(const Request& request,
                                                    PreparedMaterial material,
                                                    std::size_t max_answer_bytes) {
  const auto settings = settings_of(request.head);
  if (!settings) return settings.error();
  auto source = IncidentSource::create(request, settings->precision, 1);
  if (!source) return source.error();
  std::shared_ptr<Sampling> sampling(
      new Sampling(std::move(*source), std::move(material), *settings));
  Outcome outcome = sampling->choose_run(request);
  if (outcome) outcome = sampling->set_xi(request);
  if (outcome) outcome = sampling->allocate(request.bytes.size(), max_answer_bytes);
  if (!outcome) return outcome.error();
  return sampling;
}

Outcome Sampling::choose_run(const Request& request) {
  const std::uint64_t all = source_.samples();
  first_ = request.head.first();
  if (first_ > 0 && first_ >= all) {
    return bad_value("first", std::to_string(first_),
                     "below " + std::to_string(all) + ", the number of samples of the wi given");
  }
  count_ = request.head.has_count() ? request.head.count() : all - first_;
  const bool fits = !request.head.has_count() || (count_ > 0 && count_ <= all - first_);
  if (fits) return Ok{};
  return bad_value("count", std::to_string(count_),
                   "1 to " + std::to_string(all - first_) + ", the samples from `first` on");
}

Outcome Sampling::set_xi(const Request& request) {
  auto xi =
      NumberArray::create("xi", request.bytes, request.xi, request.xi_f64, settings().precision);
  if (!xi) return xi.error();
  if (xi->size() == 0) return Ok{};
  if (request.head.sequence() != v1::SEQUENCE_UNSPECIFIED || request.head.seed() != 0) {
    return bad_value("xi", "given, and a sequence or a seed too", "one of the two");
  }
  if (count_ != xi->size() / 3 || xi->size() % 3 != 0) {
    return bad_value("xi", "an array of " + std::to_string(xi->size()) + " numbers",
                     "three numbers for each of the " + std::to_string(count_) + " samples");
  }
  xi_ = std::move(*xi);
  return Ok{};
}

Outcome Sampling::allocate(std::size_t request_bytes, std::size_t max_answer_bytes) {
  const std::size_t number = settings().number_bytes();
  const std::size_t per_sample = (3 + 1 + channels()) * number + sizeof(std::uint8_t);
  const std::size_t most = (max_answer_bytes - std::min(max_answer_bytes, kHeadBytes)) / per_sample;
  if (count_ > most) {
    return bad_value("count", std::to_string(count_) + " samples",
                     "at most " + std::to_string(most) + " samples in one answer (" +
                         std::to_string(channels()) + " channels, " +
                         std::string(name_of(settings().precision)) +
                         "); ask for the rest in further requests");
  }
  const auto samples = static_cast<std::size_t>(count_);
  set_size(samples, request_bytes + samples * per_sample);
  auto wo = AnswerBuffer::allocate(samples * 3 * number);
  auto pdf = AnswerBuffer::allocate(samples * number);
  auto weights = AnswerBuffer::allocate(samples * channels() * number);
  auto flags = AnswerBuffer::allocate(samples);
  if (!wo || !pdf || !weights || !flags) {
    return no_memory_for(std::to_string(samples) + " samples");
  }
  wo_data_ = wo->data;
  pdf_data_ = pdf->data;
  weight_data_ = weights->data;
  flag_data_ = static_cast<std::uint8_t*>(flags->data);
  wo_ = std::move(wo->slice);
  pdf_ = std::move(pdf->slice);
  weights_ = std::move(weights->slice);
  flags_ = std::move(flags->slice);
  return Ok{};
}

template <class T>
void Sampling::sample_tile(std::size_t first, std::size_t count) {
  auto& scratch = TileScratch<T>::of_this_thread();
  const std::uint64_t begin = first_ + first;  // from the first wi given on
  const std::uint64_t wi = begin / source_.per_wi, last = (begin + count - 1) / source_.per_wi;
  source_.wi.read(3 * wi, 3 * (last - wi + 1), scratch.wi);
  if (xi_) xi_->read(3 * first, 3 * count, scratch.other);
  SampleBatch<T> batch;
  batch.wi = Directions<T>::interleaved(scratch.wi);
  batch.first = source_.first_wi * source_.per_wi + begin;
  batch.count = count;
  batch.per_wi = source_.per_wi;
  batch.xi = xi_ ? scratch.other : nullptr;
  batch.numbers = source_.numbers;
  batch.wo = static_cast<T*>(wo_data_) + 3 * first;
  batch.pdf = static_cast<T*>(pdf_data_) + first;
  batch.weights = Values<T>::interleaved(static_cast<T*>(weight_data_) + first * channels(),
                                         material().channels());
  batch.flags = flag_data_ + first;
  const Sampler& from = sampler();
  run_timed([&] {
    const SampleReport report = sample(from, batch, settings().isa);
    lost_ += report.lost;
    return report.any_flags;
  });
}

void Sampling::run_tile(std::size_t tile) {
  const std::size_t first = tile * kTilePairs;
  const std::size_t count = std::min(kTilePairs, items() - first);
  if (settings().precision == Precision::fast) return sample_tile<float>(first, count);
  sample_tile<double>(first, count);
}

wire::SampleResponseParts Sampling::take_answer() {
  wire::SampleResponseParts answer;
  answer.head.set_channels(static_cast<std::uint32_t>(channels()));
  answer.head.set_lost(lost_);
  write(*answer.head.mutable_report());
  if (any_flagged()) answer.flags = std::move(flags_);
  answer.values = std::move(weights_);
  answer.pdf = std::move(pdf_);
  answer.wo = std::move(wo_);
  answer.is_f64 = settings().precision == Precision::reference;
  return answer;
}

}  // namespace gonio::server
