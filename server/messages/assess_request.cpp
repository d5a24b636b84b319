#include "server/messages/assess_request.h"

#include <string>

#include "server/messages/decode_request.h"
#include "wire/convert.h"

namespace gonio::server {
namespace {

void fill(const assess::Worst& from, v1::AssessWorst& to) {
  to.set_error(from.error);
  to.mutable_wi()->Assign(from.at.wi.begin(), from.at.wi.end());
  to.mutable_wo()->Assign(from.at.wo.begin(), from.at.wo.end());
  to.set_channel(static_cast<std::uint32_t>(from.channel));
  to.set_value(from.value);
  to.set_truth(from.truth);
}

void fill(const assess::Findings& from, v1::AssessFindings& to) {
  to.set_nan(from.nan);
  to.set_infinite(from.infinite);
  to.set_negative(from.negative);
  to.set_stray(from.stray);
  to.set_checked(from.checked);
  fill(from.worst, *to.mutable_worst());
}

void fill(const assess::PlaceReport& from, v1::AssessPlace& to) {
  to.set_name(std::string(from.name));
  to.set_where(std::string(from.where));
  to.set_failure(std::string(from.failure));
  to.set_pairs(from.pairs);
  fill(from.fast, *to.mutable_fast());
  fill(from.reference, *to.mutable_reference());
  if (from.naive32) fill(*from.naive32, *to.mutable_naive_float32());
  if (from.naive64) fill(*from.naive64, *to.mutable_naive_float64());
  fill(from.reciprocity, *to.mutable_reciprocity());
}

void fill(const assess::Incidence& from, v1::AssessIncidence& to) {
  to.set_theta(from.theta);
  to.set_phi(from.phi);
  to.mutable_albedo()->Assign(from.albedo.begin(), from.albedo.end());
  to.mutable_sampled()->Assign(from.sampled.begin(), from.sampled.end());
  to.mutable_standard_error()->Assign(from.standard_error.begin(), from.standard_error.end());
  to.set_mass(from.mass);
  to.set_lost(from.lost);
  to.set_unsure(from.unsure);
  to.set_probability(from.probability);
  fill(from.weight, *to.mutable_weight());
  to.mutable_deviation()->Assign(from.deviation.begin(), from.deviation.end());
}

void fill(const assess::Check& from, v1::AssessCheck& to) {
  to.set_name(std::string(from.name));
  to.set_value(from.value);
  to.set_limit(from.limit);
  to.set_passed(from.passed);
  to.set_where(from.where);
  to.set_note(from.note);
}

assess::Limits limits_of(const v1::AssessLimits& from) {
  assess::Limits to;
  if (from.has_error()) to.error = from.error();
  if (from.has_reference_error()) to.reference_error = from.reference_error();
  if (from.has_reciprocity()) to.reciprocity = from.reciprocity();
  if (from.has_gain()) to.gain = from.gain();
  if (from.has_loss()) to.loss = from.loss();
  if (from.has_mass()) to.mass = from.mass();
  if (from.has_weight_error()) to.weight_error = from.weight_error();
  if (from.has_probability()) to.probability = from.probability();
  if (from.has_deviation()) to.deviation = from.deviation();
  if (from.has_missing()) to.missing = from.missing();
  if (from.has_missing_region()) to.missing_region = from.missing_region();
  if (from.has_zeros()) to.zeros = from.zeros();
  if (from.has_holes()) to.holes = from.holes();
  if (from.has_outlier()) to.outlier = from.outlier();
  if (from.has_extreme()) to.extreme = from.extreme();
  return to;
}

}  // namespace

Result<v1::AssessRequest> decode_assess_request(const grpc::ByteBuffer& buffer) {
  return decode_request<v1::AssessRequest>(buffer, {v1::AssessRequest::kMaterialFieldNumber});
}

assess::Options assess_options(const v1::AssessRequest& request) {
  assess::Options options;
  options.limits = limits_of(request.limits());
  if (request.pairs() != 0) options.pairs = request.pairs();
  if (request.seed() != 0) options.seed = request.seed();
  return options;
}

v1::AssessResponse to_wire(const assess::Report& report) {
  v1::AssessResponse response;
  response.set_passed(report.passed);
  for (const auto& check : report.checks) fill(check, *response.add_checks());
  for (const auto& place : report.places) fill(place, *response.add_places());
  for (const auto& incidence : report.incidences) fill(incidence, *response.add_incidences());
  response.set_channels(static_cast<std::uint32_t>(report.channels));
  *response.mutable_fast() = wire::to_wire(report.fast);
  *response.mutable_reference() = wire::to_wire(report.reference);
  response.set_cpu_seconds(report.cpu_seconds);
  return response;
}

}  // namespace gonio::server
