#include "server/work/evaluation.h"

#include <algorithm>
#include <string>
#include <utility>

#include "server/calls/answer_buffer.h"
#include "server/work/tile_scratch.h"

namespace gonio::server {

Result<std::shared_ptr<Evaluation>> Evaluation::prepare(const Request& request,
                                                        PreparedMaterial material,
                                                        std::size_t max_answer_bytes) {
  const auto settings = settings_of(request.head);
  if (!settings) return settings.error();
  auto source = DirectionSource::create(request, settings->precision);
  if (!source) return source.error();
  std::shared_ptr<Evaluation> evaluation(
      new Evaluation(std::move(*source), std::move(material), *settings, request.head.pdf()));
  const auto allocated = evaluation->allocate(request.bytes.size(), max_answer_bytes);
  if (!allocated) return allocated.error();
  return evaluation;
}

Outcome Evaluation::allocate(std::size_t request_bytes, std::size_t max_answer_bytes) {
  const std::size_t value_bytes = channels() * settings().number_bytes();
  const std::size_t pdf_bytes = with_pdf_ ? settings().number_bytes() : 0;
  const std::size_t per_pair = value_bytes + pdf_bytes + sizeof(std::uint8_t);
  // By division: a grid's size times anything may not fit into 64 bits.
  const std::size_t most = (max_answer_bytes - std::min(max_answer_bytes, kHeadBytes)) / per_pair;
  if (source_.size() > most) {
    return bad_value(
        source_.is_grid() ? "grid" : "pairs", std::to_string(source_.size()) + " pairs",
        "at most " + std::to_string(most) + " pairs in one answer (" + std::to_string(channels()) +
            " channels, " + std::string(name_of(settings().precision)) +
            "); ask for the rest in further requests");
  }
  const auto pairs = static_cast<std::size_t>(source_.size());
  set_size(pairs, request_bytes + pairs * per_pair);
  auto flags = AnswerBuffer::allocate(pairs);
  auto values = AnswerBuffer::allocate(pairs * value_bytes);
  auto pdf = AnswerBuffer::allocate(pairs * pdf_bytes);
  if (!flags || !values || !pdf) return no_memory_for(std::to_string(pairs) + " pairs");
  flag_data_ = static_cast<std::uint8_t*>(flags->data);
  value_data_ = values->data;
  pdf_data_ = pdf->data;
  flags_ = std::move(flags->slice);
  values_ = std::move(values->slice);
  pdf_ = std::move(pdf->slice);
  return Ok{};
}

template <class In, class Out>
void Evaluation::evaluate_tile(std::size_t first, std::size_t count) {
  auto& scratch = TileScratch<In>::of_this_thread();
  source_.read(first, count, scratch.wi, scratch.other);
  Out* values = static_cast<Out*>(value_data_) + first * channels();
  const Batch<In, Out> batch{
      Directions<In>::interleaved(scratch.wi), Directions<In>::interleaved(scratch.other), count,
      Values<Out>::interleaved(values, material().channels()), flag_data_ + first};
  if (!with_pdf_) {
    return run_timed([&] { return evaluate(material(), batch, settings().isa); });
  }
  const Sampler& with = sampler();
  Out* pdf = static_cast<Out*>(pdf_data_) + first;
  run_timed([&] { return evaluate(with, batch, pdf, settings().isa); });
}

void Evaluation::run_tile(std::size_t tile) {
  const std::size_t first = tile * kTilePairs;
  const std::size_t count = std::min(kTilePairs, items() - first);
  if (settings().precision == Precision::fast) return evaluate_tile<float, float>(first, count);
  if (source_.is_f64()) return evaluate_tile<double, double>(first, count);
  evaluate_tile<float, double>(first, count);
}

wire::ResponseParts Evaluation::take_answer() {
  wire::ResponseParts answer;
  answer.head.set_channels(static_cast<std::uint32_t>(channels()));
  write(*answer.head.mutable_report());
  if (any_flagged()) answer.flags = std::move(flags_);
  answer.values = std::move(values_);
  answer.pdf = std::move(pdf_);
  answer.is_f64 = settings().precision == Precision::reference;
  return answer;
}

}  // namespace gonio::server
