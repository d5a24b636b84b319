#include <string>
#include <utility>

#include "client/calls/batch_call.h"
#include "client/calls/state.h"
#include "client/transfer/pair_transfer.h"
#include "gonio/client/client.h"

namespace gonio::client {
namespace {

template <class Out>
Result<Report> evaluate_into(BatchCall& batch_call, ChunkSource& source, std::uint64_t pairs,
                             std::span<Out> values, std::span<Out> pdf,
                             std::span<std::uint8_t> flags) {
  auto fit = check_result_lengths("pairs", pairs, "values", values.size(), flags.size());
  if (!fit) return fit.error();
  if (pairs == 0) return batch_call.probe_for_nothing();
  ArrayReceiver<Out> receiver(values, pdf, flags, pairs);
  return batch_call.run(source, receiver, values.size() / pairs, pairs);
}

template <class In, class Out>
Result<Report> evaluate_pairs(BatchCall batch_call, std::span<const In> wi, std::span<const In> wo,
                              std::span<Out> values, std::span<Out> pdf,
                              std::span<std::uint8_t> flags) {
  if (wi.size() % 3 != 0) {
    return bad_value("the length of wi", std::to_string(wi.size()), "a multiple of 3");
  }
  if (wo.size() != wi.size()) {
    return bad_value("the length of wo", std::to_string(wo.size()),
                     "that of wi, " + std::to_string(wi.size()));
  }
  Loan loan;  // outlives all that is made of it
  ArraySource<In> source(wi, wo, batch_call.has_deadline() ? nullptr : &loan);
  return evaluate_into(batch_call, source, wi.size() / 3, values, pdf, flags);
}

template <class Out>
Result<Report> evaluate_grid(BatchCall batch_call, const Grid& grid, std::span<Out> values,
                             std::span<std::uint8_t> flags) {
  if (auto checked = check(grid); !checked) return checked.error();
  GridSource source(grid);
  return evaluate_into(batch_call, source, *grid.size(), values, {}, flags);
}

template <class In, class Out>
Result<Report> evaluate_to_sink(BatchCall& batch_call, ChunkSource& source,
                                const ChunkSink<In, Out>& sink,
                                std::optional<std::uint64_t> total) {
  auto probed = batch_call.probe();
  if (!probed) return probed;
  SinkReceiver<In, Out> receiver(sink);
  auto report = batch_call.run(source, receiver, static_cast<std::size_t>(probed->channels), total);
  if (!report || report->pairs != 0) return report;
  return about_nothing(*probed);
}

template <class T>
Result<Report> evaluate_both(BatchCall batch_call, std::span<const T> wi, std::span<const T> wo,
                             std::span<T> values, std::span<T> pdf, std::span<std::uint8_t> flags) {
  if (pdf.size() != wi.size() / 3) {
    return bad_value("the length of pdf", std::to_string(pdf.size()),
                     "one for each of the " + std::to_string(wi.size() / 3) + " pairs");
  }
  return evaluate_pairs(std::move(batch_call), wi, wo, values, pdf, flags);
}

EvaluateOptions with_pdf(EvaluateOptions options) {
  options.pdf = true;
  return options;
}

}  // namespace

Result<int> Client::channels(const Material& material) const {
  auto report = state_->batch_call(material, Precision::fast, {}).probe();
  if (!report) return report.error();
  return report->channels;
}

Result<Report> Client::evaluate(const Material& material, std::span<const float> wi,
                                std::span<const float> wo, std::span<float> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->batch_call(material, Precision::fast, options), wi, wo, values, {},
                        flags);
}

Result<Report> Client::evaluate(const Material& material, std::span<const float> wi,
                                std::span<const float> wo, std::span<double> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->batch_call(material, Precision::reference, options), wi, wo, values,
                        {}, flags);
}

Result<Report> Client::evaluate(const Material& material, std::span<const double> wi,
                                std::span<const double> wo, std::span<double> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_pairs(state_->batch_call(material, Precision::reference, options), wi, wo, values,
                        {}, flags);
}

Result<Report> Client::evaluate_with_pdf(const Material& material, std::span<const float> wi,
                                         std::span<const float> wo, std::span<float> values,
                                         std::span<float> pdf, std::span<std::uint8_t> flags,
                                         const EvaluateOptions& options) const {
  return evaluate_both(state_->batch_call(material, Precision::fast, with_pdf(options)), wi, wo,
                       values, pdf, flags);
}

Result<Report> Client::evaluate_with_pdf(const Material& material, std::span<const double> wi,
                                         std::span<const double> wo, std::span<double> values,
                                         std::span<double> pdf, std::span<std::uint8_t> flags,
                                         const EvaluateOptions& options) const {
  return evaluate_both(state_->batch_call(material, Precision::reference, with_pdf(options)), wi,
                       wo, values, pdf, flags);
}

Result<Report> Client::evaluate(const Material& material, const Grid& grid, std::span<float> values,
                                std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_grid(state_->batch_call(material, Precision::fast, options), grid, values, flags);
}

Result<Report> Client::evaluate(const Material& material, const Grid& grid,
                                std::span<double> values, std::span<std::uint8_t> flags,
                                const EvaluateOptions& options) const {
  return evaluate_grid(state_->batch_call(material, Precision::reference, options), grid, values,
                       flags);
}

template <class In, class Out>
Result<Report> Client::evaluate_chunks(const Material& material, const PairSource<In>& source,
                                       const ChunkSink<In, Out>& sink,
                                       const EvaluateOptions& options) const {
  BatchCall batch_call = state_->batch_call(material, precision_for<Out>(), options);
  CallbackSource<In> chunks(source);
  return evaluate_to_sink(batch_call, chunks, sink, std::nullopt);
}

template <class Out>
Result<Report> Client::evaluate_chunks(const Material& material, const Grid& grid,
                                       const ChunkSink<Out, Out>& sink,
                                       const EvaluateOptions& options) const {
  if (auto checked = check(grid); !checked) return checked.error();
  BatchCall batch_call = state_->batch_call(material, precision_for<Out>(), options);
  GridSource chunks(grid);
  return evaluate_to_sink(batch_call, chunks, sink, grid.size());
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
