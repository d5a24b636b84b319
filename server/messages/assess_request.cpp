#include "server/messages/assess_request.h"

#include "server/messages/decode_request.h"
#include "wire/mapping/assessment.h"

namespace gonio::server {
namespace {

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

v1::AssessResponse to_wire(const assess::Assessment& assessment) {
  return wire::to_message(assessment);
}

}  // namespace gonio::server
