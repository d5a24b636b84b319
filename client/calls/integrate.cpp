#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "client/calls/state.h"
#include "client/messages/convert.h"
#include "client/transfer/check_answer.h"
#include "gonio/client/client.h"
#include "gonio/v1/sample.pb.h"
#include "wire/message.h"

namespace gonio::client {
namespace {

// Of directions in a call: at the most channels its answer stays below 3 MiB.
constexpr std::size_t kDirections = 2048;

Outcome check(std::size_t numbers, std::uint64_t per_wi) {
  if (numbers % 3 != 0) {
    return bad_value("the length of wi", std::to_string(numbers), "a multiple of 3");
  }
  if (per_wi < 2) return bad_value("per_wi", std::to_string(per_wi), "2 or more");
  return Ok{};
}

template <class T>
gonio::v1::IntegrateRequest directions_of(std::span<const T> wi, std::size_t first) {
  gonio::v1::IntegrateRequest request;
  request.set_first_wi(first);
  const auto run = wi.subspan(3 * first, std::min(3 * kDirections, wi.size() - 3 * first));
  if constexpr (std::is_same_v<T, double>) {
    request.mutable_wi_f64()->Add(run.begin(), run.end());
  } else {
    request.mutable_wi()->Add(run.begin(), run.end());
  }
  return request;
}

// Appends an answer for `directions`.
Outcome append(const Peer& peer, const gonio::v1::IntegrateResponse& answer, std::size_t directions,
               Albedos& to) {
  const auto channels = static_cast<int>(answer.channels());
  const auto values = static_cast<int>(directions) * channels;
  const bool fits = channels > 0 && (to.report.channels == 0 || to.report.channels == channels) &&
                    answer.albedo_size() == values && answer.standard_error_size() == values &&
                    std::cmp_equal(answer.lost_size(), directions) &&
                    (answer.holes().empty() || std::cmp_equal(answer.holes_size(), directions)) &&
                    (answer.flags().empty() || answer.flags().size() == directions);
  if (!fits) return malformed(peer, std::to_string(answer.albedo_size()) + " albedos");
  to.report.channels = channels;
  to.report.kernel_seconds += answer.report().kernel_seconds();
  to.report.instruction_set = instruction_set_of(answer.report().instruction_set());
  to.report.error_bound = error_bound_of(answer.report().error_bound());
  to.albedo.insert(to.albedo.end(), answer.albedo().begin(), answer.albedo().end());
  to.standard_error.insert(to.standard_error.end(), answer.standard_error().begin(),
                           answer.standard_error().end());
  to.lost.insert(to.lost.end(), answer.lost().begin(), answer.lost().end());
  to.holes.insert(to.holes.end(), answer.holes().begin(), answer.holes().end());
  to.holes.resize(to.lost.size());
  to.flags.insert(to.flags.end(), answer.flags().begin(), answer.flags().end());
  to.flags.resize(to.lost.size());
  return Ok{};
}

template <class T>
Result<Albedos> integrate_all(const Peer& peer, const RequestHead& head, Patience patience,
                              std::span<const T> wi, std::uint64_t per_wi) {
  if (auto checked = check(wi.size(), per_wi); !checked) return checked.error();
  Albedos albedos;
  albedos.report.precision = head.precision();
  std::size_t first = 0;
  do {  // without directions too: the material is checked, and the report says what it is
    const auto request = directions_of(wi, first);
    const std::size_t directions = std::min(kDirections, wi.size() / 3 - first);
    // The head goes as the bytes it is: that is how the server knows a material again.
    const std::array slices{grpc::Slice(std::string(head.with_material())),
                            grpc::Slice(request.SerializeAsString())};
    auto bytes = call(peer, kIntegrateMethod, {slices.data(), slices.size()}, patience);
    if (!bytes) return bytes.error();
    gonio::v1::IntegrateResponse answer;
    if (!wire::from_buffer(*bytes, answer)) return malformed(peer, "it cannot be read");
    if (auto added = append(peer, answer, directions, albedos); !added) return added.error();
    first += directions;
  } while (first < wi.size() / 3);
  albedos.report.pairs = first * per_wi;
  albedos.report.retries = patience.retries();
  for (const double lost : albedos.lost) {
    albedos.report.lost +=
        static_cast<std::uint64_t>(std::llround(lost * static_cast<double>(per_wi)));
  }
  return albedos;
}

}  // namespace

Result<Albedos> Client::integrate(const Material& material, std::span<const float> wi,
                                  std::uint64_t per_wi, const NumberSource& numbers,
                                  const EvaluateOptions& options) const {
  const auto head = RequestHead::integrate(material, Precision::fast, options, per_wi, numbers);
  return integrate_all(state_->peer, head, Patience(state_->options, options.deadline), wi, per_wi);
}

Result<Albedos> Client::integrate(const Material& material, std::span<const double> wi,
                                  std::uint64_t per_wi, const NumberSource& numbers,
                                  const EvaluateOptions& options) const {
  const auto head =
      RequestHead::integrate(material, Precision::reference, options, per_wi, numbers);
  return integrate_all(state_->peer, head, Patience(state_->options, options.deadline), wi, per_wi);
}

}  // namespace gonio::client
