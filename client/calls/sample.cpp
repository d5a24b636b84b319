#include <algorithm>
#include <optional>
#include <string>

#include "client/calls/state.h"
#include "client/transfer/sample_transfer.h"
#include "gonio/client/client.h"

namespace gonio::client {
namespace {

constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 62;

Outcome check_count(std::uint64_t directions, std::uint64_t per_wi, std::uint64_t least) {
  if (per_wi < least) {
    return bad_value("per_wi", std::to_string(per_wi), std::to_string(least) + " or more");
  }
  if (directions == 0 || per_wi <= kMostSamples / directions) return Ok{};
  return bad_value("per_wi", std::to_string(per_wi), "at most 2^62 samples, all wi together",
                   ErrorCode::resource_exhausted);
}

template <class T>
Outcome check_directions(std::span<const T> wi) {
  if (wi.size() % 3 == 0) return Ok{};
  return bad_value("the length of wi", std::to_string(wi.size()), "a multiple of 3");
}

template <class T>
Outcome check_lengths(const SampleBatch<T>& batch, const Samples<T>& results) {
  if (auto whole = check_directions(batch.wi); !whole) return whole;
  const std::uint64_t directions = batch.wi.size() / 3, samples = results.pdf.size();
  if (auto count = check_count(directions, batch.per_wi, 1); !count) return count;
  const std::uint64_t all = directions * batch.per_wi;
  if (batch.first > all || samples > all - batch.first) {
    return bad_value("the length of pdf", std::to_string(samples),
                     "at most the " + std::to_string(all - std::min(all, batch.first)) +
                         " samples from `first` on");
  }
  if (results.wo.size() != 3 * samples) {
    return bad_value("the length of wo", std::to_string(results.wo.size()),
                     "three for each of the " + std::to_string(samples) + " samples");
  }
  if (!batch.xi.empty() && batch.xi.size() != 3 * samples) {
    return bad_value("the length of xi", std::to_string(batch.xi.size()),
                     "0, or three for each of the " + std::to_string(samples) + " samples");
  }
  return check_result_lengths("samples", samples, "weights", results.weights.size(),
                              results.flags.size());
}

template <class T>
Result<Report> sample_into(BatchCall batch_call, const SampleBatch<T>& batch,
                           const Samples<T>& results) {
  const std::uint64_t samples = results.pdf.size();
  if (samples == 0) return batch_call.probe_for_nothing();
  Loan loan;  // outlives all that is made of it
  SampleArraySource<T> source(batch, samples, batch_call.has_deadline() ? nullptr : &loan);
  SampleArrayReceiver<T> receiver(results, batch.first);
  return batch_call.run(source, receiver, results.weights.size() / samples, samples);
}

template <class T>
RequestHead head_of(const Material& material, const SampleBatch<T>& batch,
                    const EvaluateOptions& options) {
  constexpr Precision kPrecision = precision_for<T>();
  return batch.xi.empty()
             ? RequestHead::sample(material, kPrecision, options, batch.per_wi, batch.numbers)
             : RequestHead::sample(material, kPrecision, options, batch.per_wi);
}

}  // namespace

Result<Report> Client::sample(const Material& material, const SampleBatch<float>& batch,
                              const Samples<float>& results, const EvaluateOptions& options) const {
  if (auto fit = check_lengths(batch, results); !fit) return fit.error();
  return sample_into(state_->batch_call(material, head_of(material, batch, options), options),
                     batch, results);
}

Result<Report> Client::sample(const Material& material, const SampleBatch<double>& batch,
                              const Samples<double>& results,
                              const EvaluateOptions& options) const {
  if (auto fit = check_lengths(batch, results); !fit) return fit.error();
  return sample_into(state_->batch_call(material, head_of(material, batch, options), options),
                     batch, results);
}

template <class T>
Result<Report> Client::sample_chunks(const Material& material, const DirectionSource<T>& source,
                                     std::uint64_t per_wi, const NumberSource& numbers,
                                     const SampleSink<T>& sink,
                                     const EvaluateOptions& options) const {
  if (auto count = check_count(1, per_wi, 1); !count) return count.error();
  BatchCall batch_call = state_->batch_call(
      material, RequestHead::sample(material, precision_for<T>(), options, per_wi, numbers),
      options);
  auto probed = batch_call.probe();
  if (!probed) return probed;
  SampleCallbackSource<T> chunks(source, per_wi);
  SampleSinkReceiver<T> receiver(sink, per_wi);
  auto report =
      batch_call.run(chunks, receiver, static_cast<std::size_t>(probed->channels), std::nullopt);
  if (!report || report->pairs != 0) return report;
  return about_nothing(*probed);
}

template Result<Report> Client::sample_chunks(const Material&, const DirectionSource<float>&,
                                              std::uint64_t, const NumberSource&,
                                              const SampleSink<float>&,
                                              const EvaluateOptions&) const;
template Result<Report> Client::sample_chunks(const Material&, const DirectionSource<double>&,
                                              std::uint64_t, const NumberSource&,
                                              const SampleSink<double>&,
                                              const EvaluateOptions&) const;

}  // namespace gonio::client
