#include "server/evaluation.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "server/answer_buffer.h"
#include "wire/convert.h"

namespace gonio {
namespace {

// Room for everything in an answer that is not values or flags: numbers, the error bound's note,
// tags and lengths.
constexpr std::size_t kHeadBytes = 4096;

Result<Isa> choose_isa(v1::InstructionSet asked) {
  if (asked == v1::INSTRUCTION_SET_UNSPECIFIED) return best_isa();
  const auto isa = wire::from_wire(asked);
  if (!isa || is_supported(*isa)) return isa;
  std::string supported;
  for (Isa one : supported_isas())
    supported += (supported.empty() ? "" : ", ") + std::string(name_of(one));
  return bad_value("instruction_set", std::string(name_of(*isa)),
                   "what this server's processor has: " + supported);
}

std::size_t answer_bytes_per_pair(Precision precision, int channels) {
  const std::size_t value = precision == Precision::fast ? sizeof(float) : sizeof(double);
  return static_cast<std::size_t>(channels) * value + sizeof(std::uint8_t);
}

// Per thread, so that no tile allocates.
template <class T>
struct Scratch {
  alignas(64) T wi[3 * kTilePairs];
  alignas(64) T wo[3 * kTilePairs];

  static Scratch& of_this_thread() {
    thread_local const auto scratch = std::make_unique<Scratch>();
    return *scratch;
  }
};

}  // namespace

Result<std::shared_ptr<Evaluation>> Evaluation::prepare(const wire::Request& request,
                                                        Material material,
                                                        std::size_t max_answer_bytes) {
  const auto precision = wire::from_wire(request.head.precision());
  if (!precision) return precision.error();
  const auto isa = choose_isa(request.head.instruction_set());
  if (!isa) return isa.error();
  auto source = DirectionSource::create(request, *precision);
  if (!source) return source.error();
  std::shared_ptr<Evaluation> evaluation(new Evaluation(std::move(*source), std::move(material)));
  evaluation->precision_ = *precision;
  evaluation->isa_ = *isa;
  evaluation->channels_ = evaluation->material_.channels();
  evaluation->request_bytes_ = request.bytes.size();
  const auto allocated = evaluation->allocate(max_answer_bytes);
  if (!allocated) return allocated.error();
  return evaluation;
}

Outcome Evaluation::allocate(std::size_t max_answer_bytes) {
  const std::size_t per_pair = answer_bytes_per_pair(precision_, channels_);
  // By division: a grid's size times anything may not fit into 64 bits.
  const std::size_t most = (max_answer_bytes - std::min(max_answer_bytes, kHeadBytes)) / per_pair;
  if (source_.size() > most) {
    return bad_value(
        source_.is_grid() ? "grid" : "pairs", std::to_string(source_.size()) + " pairs",
        "at most " + std::to_string(most) + " pairs in one answer (" + std::to_string(channels_) +
            " channels, " + std::string(name_of(precision_)) +
            "); ask for the rest in further requests");
  }
  pairs_ = static_cast<std::size_t>(source_.size());
  auto flags = AnswerBuffer::allocate(pairs_);
  auto values = AnswerBuffer::allocate(pairs_ * (per_pair - sizeof(std::uint8_t)));
  if (!flags || !values) {
    return Error{ErrorCode::resource_exhausted,
                 "no memory for " + std::to_string(pairs_) + " pairs", "", "", ""};
  }
  flag_data_ = static_cast<std::uint8_t*>(flags->data);
  value_data_ = values->data;
  flags_ = std::move(flags->slice);
  values_ = std::move(values->slice);
  return Ok{};
}

template <class In, class Out>
void Evaluation::evaluate_tile(std::size_t first, std::size_t count) {
  auto& scratch = Scratch<In>::of_this_thread();
  source_.read(first, count, scratch.wi, scratch.wo);
  Out* values = static_cast<Out*>(value_data_) + first * static_cast<std::size_t>(channels_);
  const Batch<In, Out> batch{Directions<In>::interleaved(scratch.wi),
                             Directions<In>::interleaved(scratch.wo), count,
                             Values<Out>::interleaved(values, channels_), flag_data_ + first};
  const auto start = std::chrono::steady_clock::now();
  const std::uint8_t flags = evaluate(material_, batch, isa_);
  const auto taken = std::chrono::steady_clock::now() - start;
  kernel_nanoseconds_ += std::chrono::duration_cast<std::chrono::nanoseconds>(taken).count();
  any_flags_ |= flags;
}

void Evaluation::run_tile(std::size_t tile) {
  const std::size_t first = tile * kTilePairs;
  const std::size_t count = std::min(kTilePairs, pairs_ - first);
  if (precision_ == Precision::fast) return evaluate_tile<float, float>(first, count);
  if (source_.is_f64()) return evaluate_tile<double, double>(first, count);
  evaluate_tile<float, double>(first, count);
}

void Evaluation::run_all() {
  for (std::size_t tile = 0; tile < tiles(); ++tile) run_tile(tile);
}

double Evaluation::kernel_seconds() const {
  return 1e-9 * static_cast<double>(kernel_nanoseconds_.load());
}

wire::ResponseParts Evaluation::take_answer() {
  wire::ResponseParts answer;
  answer.head.set_channels(static_cast<std::uint32_t>(channels_));
  v1::Report& report = *answer.head.mutable_report();
  report.set_kernel_seconds(kernel_seconds());
  report.set_instruction_set(wire::to_wire(isa_));
  report.set_precision(wire::to_wire(precision_));
  *report.mutable_error_bound() = wire::to_wire(material_.error_bound(precision_));
  if (any_flags_ != 0) answer.flags = std::move(flags_);
  answer.values = std::move(values_);
  answer.is_f64 = precision_ == Precision::reference;
  return answer;
}

}  // namespace gonio
