#include <string>
#include <type_traits>

#include "client/chunks.h"
#include "client/client.h"
#include "client/evaluation.h"
#include "client/state.h"

namespace gonio::client {
namespace {

template <class Out>
Outcome check_results(std::uint64_t pairs, std::span<Out> values, std::span<std::uint8_t> flags) {
  const bool whole = pairs == 0 ? values.empty() : values.size() % pairs == 0;
  const std::size_t channels = pairs == 0 ? 1 : values.size() / pairs;
  if (!whole || channels < 1 || channels > kMaxChannels) {
    return bad_value("the length of values", std::to_string(values.size()),
                     std::to_string(pairs) + " pairs x the material's channels (1 to 64)");
  }
  if (!flags.empty() && flags.size() != pairs) {
    return bad_value("the length of flags", std::to_string(flags.size()),
                     "0, or one byte for each of the " + std::to_string(pairs) + " pairs");
  }
  return Ok{};
}

// No pairs: the material is checked all the same, and the report says what it is.
Result<Report> evaluate_nothing(Evaluation& evaluation) {
  auto report = evaluation.probe();
  if (!report) return report;
  report->pairs = 0;
  report->kernel_seconds = 0;
  return report;
}

template <class Out>
Result<Report> evaluate_into(Evaluation& evaluation, ChunkSource& source, std::uint64_t pairs,
                             std::span<Out> values, std::span<std::uint8_t> flags) {
  if (auto fit = check_results(pairs, values, flags); !fit) return fit.error();
  if (pairs == 0) return evaluate_nothing(evaluation);
  ArrayReceiver<Out> receiver(values, flags, pairs);
  return evaluation.run(source, receiver, values.size() / pairs, pairs);
}

template <class Out>
constexpr Precision precision_for() {
  return std::is_same_v<Out, double> ? Precision::reference : Precision::fast;
}

template <class In, class Out>
Result<Report> evaluate_pairs(Evaluation evaluation, std::span<const In> wi, std::span<const In> wo,
                              std::span<Out> values, std::span<std::uint8_t> flags) {
  if (wi.size() % 3 != 0) {
    return bad_value("the length of wi", std::to_string(wi.size()), "a multiple of 3");
  }
  if (wo.size() != wi.size()) {
    return bad_value("the length of wo", std::to_string(wo.size()),
                     "that of wi, " + std::to_string(wi.size()));
  }
  Loan loan;  // outlives all that is made of it
  ArraySource<In> source(wi, wo, evaluation.has_deadline() ? nullptr : &loan);
  return evaluate_into(evaluation, source, wi.size() / 3, values, flags);
}

template <class Out>
Result<Report> evaluate_grid(Evaluation evaluation, const Grid& grid, std::span<Out> values,
                             std::span<std::uint8_t> flags) {
  if (auto checked = check(grid); !checked) return checked.error();
  GridSource source(grid);
  return evaluate_into(evaluation, source, *grid.size(), values, flags);
}

template <class In, class Out>
Result<Report> evaluate_to_sink(Evaluation& evaluation, ChunkSource& source,
                                const ChunkSink<In, Out>& sink,
                                std::optional<std::uint64_t> total) {
  auto probed = evaluation.probe();
  if (!probed) return probed;
  SinkReceiver<In, Out> receiver(sink);
  auto report = evaluation.run(source, receiver, static_cast<std::size_t>(probed->channels), total);
  if (!report || report->pairs != 0) return report;
  probed->pairs = 0;
  probed->kernel_seconds = 0;
  return probed;
}

}  // namespace

Result<int> Client::channels(const Material& material) const {
  auto report = state_->evaluation(material, Precision::fast, {}).probe();
  if (!report) return report.error();
  return report->channels;
}

Result<Report> Client::evaluate(const Material& material, std::span<const float> wi,
                                std::span<const float> wo, std::span<float> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->evaluation(material, Precision::fast, options), wi, wo, values,
                        flags);
}

Result<Report> Client::evaluate(const Material& material, std::span<const float> wi,
                                std::span<const float> wo, std::span<double> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->evaluation(material, Precision::reference, options), wi, wo, values,
                        flags);
}

Result<Report> Client::evaluate(const Material& material, std::span<const double> wi,
                                std::span<const double> wo, std::span<double> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->evaluation(material, Precision::reference, options), wi, wo, values,
                        flags);
}

Result<Report> Client::evaluate(const Material& material, const Grid& grid, std::span<float> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_grid(state_->evaluation(material, Precision::fast, options), grid, values, flags);
}

Result<Report> Client::evaluate(const Material& material, const Grid& grid,
                                std::span<double> values, std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_grid(state_->evaluation(material, Precision::reference, options), grid, values,
                       flags);
}

template <class In, class Out>
Result<Report> Client::evaluate_chunks(const Material& material, const PairSource<In>& source,
                                       const ChunkSink<In, Out>& sink,
                                       const EvaluateOptions& options) const {
  Evaluation evaluation = state_->evaluation(material, precision_for<Out>(), options);
  CallbackSource<In> chunks(source);
  return evaluate_to_sink(evaluation, chunks, sink, std::nullopt);
}

template <class Out>
Result<Report> Client::evaluate_chunks(const Material& material, const Grid& grid,
                                       const ChunkSink<Out, Out>& sink,
                                       const EvaluateOptions& options) const {
  if (auto checked = check(grid); !checked) return checked.error();
  Evaluation evaluation = state_->evaluation(material, precision_for<Out>(), options);
  GridSource chunks(grid);
  return evaluate_to_sink(evaluation, chunks, sink, grid.size());
}

template Result<Report> Client::evaluate_chunks(const Material&, const PairSource<float>&,
                                                const ChunkSink<float, float>&,
                                                const EvaluateOptions&) const;
template Result<Report> Client::evaluate_chunks(const Material&, const PairSource<float>&,
                                                const ChunkSink<float, double>&,
                                                const EvaluateOptions&) const;
template Result<Report> Client::evaluate_chunks(const Material&, const PairSource<double>&,
                                                const ChunkSink<double, double>&,
                                                const EvaluateOptions&) const;
template Result<Report> Client::evaluate_chunks(const Material&, const Grid&,
                                                const ChunkSink<float, float>&,
                                                const EvaluateOptions&) const;
template Result<Report> Client::evaluate_chunks(const Material&, const Grid&,
                                                const ChunkSink<double, double>&,
                                                const EvaluateOptions&) const;

}  // namespace gonio::client
