#include "client/messages/assess_request.h"

#include <optional>

#include "client/messages/convert.h"

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

}  // namespace

Result<v1::AssessRequest> assess_request(const Material& material, const AssessOptions& options) {
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

}  // namespace gonio::client
