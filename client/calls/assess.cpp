#include <string>
#include <utility>

#include "client/calls/state.h"
#include "client/messages/convert.h"
#include "client/messages/message_json.h"
#include "client/messages/repeated.h"
#include "client/transfer/check_answer.h"
#include "gonio/client/client.h"
#include "gonio/v1/assess.pb.h"
#include "wire/message.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

template <class Set>
void set(const std::optional<double>& limit, const Set& to) {
  if (limit) to(*limit);
}

void fill(const AssessLimits& from, v1::AssessLimits& to) {
  set(from.error, [&](double x) { to.set_error(x); });
  set(from.reference_error, [&](double x) { to.set_reference_error(x); });
  set(from.reciprocity, [&](double x) { to.set_reciprocity(x); });
  set(from.gain, [&](double x) { to.set_gain(x); });
  set(from.loss, [&](double x) { to.set_loss(x); });
  set(from.mass, [&](double x) { to.set_mass(x); });
  set(from.weight_error, [&](double x) { to.set_weight_error(x); });
  set(from.probability, [&](double x) { to.set_probability(x); });
  set(from.deviation, [&](double x) { to.set_deviation(x); });
  set(from.missing, [&](double x) { to.set_missing(x); });
  set(from.missing_region, [&](double x) { to.set_missing_region(x); });
  set(from.zeros, [&](double x) { to.set_zeros(x); });
  set(from.holes, [&](double x) { to.set_holes(x); });
  set(from.outlier, [&](double x) { to.set_outlier(x); });
  set(from.extreme, [&](double x) { to.set_extreme(x); });
}

// 0 would mean the default on the wire.
Outcome check(const AssessOptions& options) {
  if (options.pairs == 0) return bad_value("pairs", "0", "1 to 1000000");
  if (options.seed == 0) return bad_value("seed", "0", "1 or more");
  return Ok{};
}

Result<v1::AssessRequest> request_of(const Material& material, const AssessOptions& options) {
  if (auto checked = check(options); !checked) return checked.error();
  v1::AssessRequest request;
  if (!request.mutable_material()->ParseFromString(material.wire()))
    return bad_value("material", "not readable", "one made by client::Material");
  fill(options.limits, *request.mutable_limits());
  request.set_pairs(options.pairs);
  request.set_seed(options.seed);
  request.set_instruction_set(to_wire(options.instruction_set));
  return request;
}

AssessWorst worst_of(const v1::AssessWorst& from) {
  return {
      from.error(), direction_of(from.wi()), direction_of(from.wo()), from.channel(), from.value(),
      from.truth()};
}

AssessFindings findings_of(const v1::AssessFindings& from) {
  return {from.nan(),   from.infinite(), from.negative(),
          from.stray(), from.checked(),  worst_of(from.worst())};
}

AssessPlace place_of(const v1::AssessPlace& from) {
  AssessPlace to;
  to.name = from.name(), to.where = from.where(), to.failure = from.failure();
  to.pairs = from.pairs();
  to.fast = findings_of(from.fast());
  to.reference = findings_of(from.reference());
  if (from.has_naive_float32()) to.naive32 = findings_of(from.naive_float32());
  if (from.has_naive_float64()) to.naive64 = findings_of(from.naive_float64());
  to.reciprocity = worst_of(from.reciprocity());
  return to;
}

AssessIncidence incidence_of(const v1::AssessIncidence& from) {
  AssessIncidence to;
  to.theta = from.theta(), to.phi = from.phi();
  to.albedo = list<double>(from.albedo());
  to.sampled = list<double>(from.sampled());
  to.standard_error = list<double>(from.standard_error());
  to.mass = from.mass(), to.lost = from.lost(), to.unsure = from.unsure();
  to.probability = from.probability();
  to.weight = worst_of(from.weight());
  to.deviation = list<double>(from.deviation());
  return to;
}

AssessCheck check_of(const v1::AssessCheck& from) {
  return {from.name(), from.value(), from.limit(), from.passed(), from.where(), from.note()};
}

Result<Assessment> assessment_of(const v1::AssessResponse& response) {
  auto json = json_of(response);
  if (!json) return json.error();
  Assessment to;
  to.passed = response.passed();
  to.checks = all(response.checks(), check_of);
  to.places = all(response.places(), place_of);
  to.incidences = all(response.incidences(), incidence_of);
  to.channels = static_cast<int>(response.channels());
  to.fast = error_bound_of(response.fast());
  to.reference = error_bound_of(response.reference());
  to.instruction_set = instruction_set_of(response.instruction_set());
  to.cpu_seconds = response.cpu_seconds();
  to.json = std::move(*json);
  return to;
}

}  // namespace

Result<Assessment> Client::assess(const Material& material, const AssessOptions& options) const {
  const auto request = request_of(material, options);
  if (!request) return request.error();
  Patience patience(state_->options, options.deadline);
  auto bytes = call(state_->peer, kAssessMethod, wire::to_buffer(*request), patience);
  if (!bytes) return bytes.error();
  v1::AssessResponse response;
  if (!wire::from_buffer(*bytes, response)) return malformed(state_->peer, "it cannot be read");
  return assessment_of(response);
}

}  // namespace gonio::client
