#include "client/calls/batch_call.h"

#include <algorithm>
#include <string>
#include <utility>

#include "client/transfer/pair_transfer.h"
#include "client/transfer/transfer.h"

namespace gonio::client {
namespace {

// An answer stays below the 4 MiB that a gRPC channel accepts by default.
constexpr std::size_t kMaxAnswerBytes = std::size_t{3} << 20;

}  // namespace

BatchCall::BatchCall(const Peer& peer, const ClientOptions& options,
                     const EvaluateOptions& evaluate_options, const Material& material,
                     RequestHead head)
    : peer_(peer),
      options_(options),
      evaluate_options_(evaluate_options),
      material_(material),
      patience_(options, evaluate_options.deadline),
      head_(std::move(head)) {}

std::size_t BatchCall::chunk_limit(std::size_t channels) const {
  const bool f64 = head_.precision() == Precision::reference;
  const std::size_t numbers = channels + (head_.wants_pdf() ? 1 : 0) + (head_.wants_wo() ? 3 : 0);
  const std::size_t pair_bytes = numbers * (f64 ? sizeof(double) : sizeof(float));
  return std::min(options_.chunk_pairs, std::max<std::size_t>(kMaxAnswerBytes / pair_bytes, 1));
}

Result<Report> BatchCall::probe() {
  static constexpr std::array<float, 3> kNormal = {0, 0, 1};
  class Nowhere final : public ChunkReceiver {
    [[nodiscard]] bool ordered() const override { return false; }
    Outcome accept(const OutgoingChunk&, const Answer&, Report&) override { return Ok{}; }
  } receiver;
  ArraySource<float> source(kNormal, kNormal, nullptr);
  EvaluateOptions options = evaluate_options_;
  options.pdf = false;
  const RequestHead head = RequestHead::evaluate(material_, head_.precision(), options);
  Transfer transfer(peer_, options_, head, patience_, source, receiver);
  if (auto outcome = transfer.run_call(1); !outcome) return outcome.error();
  return transfer.report();
}

Report about_nothing(Report probed) {
  probed.pairs = 0;
  probed.kernel_seconds = 0;
  return probed;
}

Result<Report> BatchCall::probe_for_nothing() {
  auto report = probe();
  if (!report) return report;
  return about_nothing(*report);
}

Result<Report> BatchCall::run(ChunkSource& source, ChunkReceiver& receiver, std::size_t channels,
                              std::optional<std::uint64_t> total) {
  const std::size_t limit = chunk_limit(channels);
  Transfer transfer(peer_, options_, head_, patience_, source, receiver);
  const bool one_call = total && *total <= limit;
  auto outcome = one_call ? transfer.run_call(limit) : transfer.run_stream(limit);
  if (!outcome) return outcome.error();
  return transfer.report();
}

Outcome check_result_lengths(const char* items, std::uint64_t count, const char* name,
                             std::size_t values, std::size_t flags) {
  const std::string number = std::to_string(count) + " " + items;
  const bool whole = count == 0 ? values == 0 : values % count == 0;
  const std::size_t channels = count == 0 ? 1 : values / count;
  if (!whole || channels < 1 || channels > kMaxChannels) {
    return bad_value(std::string("the length of ") + name, std::to_string(values),
                     number + " x the material's channels (1 to 64)");
  }
  if (flags != 0 && flags != count) {
    return bad_value("the length of flags", std::to_string(flags),
                     "0, or one byte for each of the " + number);
  }
  return Ok{};
}

Outcome check(const Grid& grid) {
  const std::array<std::pair<const char*, std::size_t>, 4> spherical = {
      {{"theta_i", grid.theta_i.size()},
       {"phi_i", grid.phi_i.size()},
       {"theta_o", grid.theta_o.size()},
       {"phi_o", grid.phi_o.size()}}};
  const std::array<std::pair<const char*, std::size_t>, 3> half = {
      {{"theta_h", grid.theta_h.size()},
       {"theta_d", grid.theta_d.size()},
       {"phi_d", grid.phi_d.size()}}};
  const auto given = [](const auto& axis) { return axis.second != 0; };
  const auto check_axes = [&](const auto& wanted, const auto& others) -> Outcome {
    if (std::any_of(others.begin(), others.end(), given)) {
      return bad_value("grid", "axes of both kinds",
                       "theta_i, phi_i, theta_o, phi_o, or theta_h, theta_d, phi_d");
    }
    const auto empty = std::find_if_not(wanted.begin(), wanted.end(), given);
    if (empty == wanted.end()) return Ok{};
    return bad_value(std::string("grid.") + empty->first, "empty", "one angle or more");
  };
  if (auto outcome = grid.half_angle() ? check_axes(half, spherical) : check_axes(spherical, half);
      !outcome) {
    return outcome;
  }
  if (!grid.size()) {
    return bad_value("the number of pairs of the grid", "above 2^63", "2^63 - 1 or fewer",
                     ErrorCode::resource_exhausted);
  }
  return Ok{};
}

}  // namespace gonio::client
