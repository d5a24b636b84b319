#include "server/messages/fit_messages.h"

#include <string>

#include "server/messages/material_message.h"

namespace gonio::server {
namespace {

v1::FitVerdict verdict_of(fit::Verdict verdict) {
  switch (verdict) {
    case fit::Verdict::converged:
      return v1::FIT_VERDICT_CONVERGED;
    case fit::Verdict::bound_limited:
      return v1::FIT_VERDICT_BOUND_LIMITED;
    case fit::Verdict::ambiguous:
      return v1::FIT_VERDICT_AMBIGUOUS;
    case fit::Verdict::failed:
      return v1::FIT_VERDICT_FAILED;
  }
  return v1::FIT_VERDICT_UNSPECIFIED;
}

v1::FitObjective objective_of(fit::Objective objective) {
  switch (objective) {
    case fit::Objective::l1:
      return v1::FIT_OBJECTIVE_L1;
    case fit::Objective::l2:
      return v1::FIT_OBJECTIVE_L2;
    case fit::Objective::huber:
      return v1::FIT_OBJECTIVE_HUBER;
    case fit::Objective::log:
      return v1::FIT_OBJECTIVE_LOG;
    case fit::Objective::cbrt:
      return v1::FIT_OBJECTIVE_CBRT;
  }
  return v1::FIT_OBJECTIVE_UNSPECIFIED;
}

void fill(const fit::LeftOut& from, v1::FitLeftOut& to) {
  to.set_not_finite(from.not_finite);
  to.set_not_unit(from.not_unit);
  to.set_below_horizon(from.below_horizon);
  to.set_negative(from.negative);
  to.set_no_weight(from.no_weight);
}

void fill(const fit::Stage& from, v1::FitStage& to) {
  to.set_name(from.name);
  to.set_objective(from.objective);
  to.set_pairs(from.pairs);
  to.set_iterations(from.iterations);
  to.set_cpu_seconds(from.cpu_seconds);
}

void fill(const fit::Start& from, v1::FitStart& to) {
  to.set_given(from.given);
  to.mutable_from()->Assign(from.from.begin(), from.from.end());
  to.mutable_to()->Assign(from.to.begin(), from.to.end());
  to.set_objective(from.objective);
  to.set_agrees(from.agrees);
}

void fill(const fit::ParameterReport& from, v1::FitParameter& to) {
  to.set_field(from.field);
  to.set_channel(from.channel);
  to.set_value(from.value);
  to.set_standard_error(from.standard_error);
  to.set_at_bound(from.at_bound);
  to.set_lower(from.lower);
  to.set_upper(from.upper);
  to.set_undetermined(!from.determined);
}

void fill(const fit::Indistinct& from, v1::FitIndistinct& to) {
  to.mutable_fields()->Assign(from.fields.begin(), from.fields.end());
  to.set_eigenvalue(from.eigenvalue);
}

void fill(const fit::Profile& from, v1::FitProfile& to) {
  to.set_field(from.field);
  to.set_lower(from.lower);
  to.set_upper(from.upper);
  to.set_part(from.part);
  to.set_separate(from.separate);
}

void fill(const fit::Errors& from, v1::FitErrors& to) {
  to.set_l1(from.l1);
  to.set_rmse(from.rmse);
  to.set_log(from.log);
  to.set_cbrt(from.cbrt);
  to.set_pairs(from.pairs);
}

void fill(const fit::Place& from, v1::FitPlace& to) {
  to.mutable_wi()->Assign(from.wi.begin(), from.wi.end());
  to.mutable_wo()->Assign(from.wo.begin(), from.wo.end());
  to.set_channel(from.channel);
  to.set_measured(from.measured);
  to.set_fitted(from.fitted);
  to.set_share(from.share);
}

void fill(const fit::Region& from, v1::FitRegion& to) {
  to.set_measured(from.measured);
  to.set_fitted(from.fitted);
  to.set_error(from.error);
}

void fill(const fit::Albedo& from, v1::FitAlbedo& to) {
  to.set_theta(from.theta);
  to.mutable_channels()->Assign(from.channels.begin(), from.channels.end());
}

template <class From, class To>
void fill_all(const std::vector<From>& from, google::protobuf::RepeatedPtrField<To>& to) {
  for (const From& element : from) fill(element, *to.Add());
}

void fill(const fit::Certificate& from, v1::FitCertificate& to) {
  to.set_verdict(verdict_of(from.verdict));
  to.set_reason(from.reason);
  to.set_objective(objective_of(from.objective));
  to.set_pairs(from.pairs);
  fill(from.left_out, *to.mutable_left_out());
  fill_all(from.stages, *to.mutable_stages());
  to.mutable_shapes()->Assign(from.shapes.begin(), from.shapes.end());
  fill_all(from.starts, *to.mutable_starts());
  to.set_agreeing(from.agreeing);
  to.set_gradient_norm(from.gradient_norm);
  fill_all(from.parameters, *to.mutable_parameters());
  to.mutable_active_bounds()->Assign(from.active_bounds.begin(), from.active_bounds.end());
  fill_all(from.indistinct, *to.mutable_indistinct());
  fill_all(from.profiles, *to.mutable_profiles());
  fill(from.errors.all, *to.mutable_errors()->mutable_all());
  fill(from.errors.below_80, *to.mutable_errors()->mutable_below_80());
  fill(from.errors.above_80, *to.mutable_errors()->mutable_above_80());
  fill_all(from.worst, *to.mutable_worst());
  fill(from.regions.mirror, *to.mutable_regions()->mutable_mirror());
  fill(from.regions.toward_light, *to.mutable_regions()->mutable_toward_light());
  fill(from.regions.elsewhere, *to.mutable_regions()->mutable_elsewhere());
  fill_all(from.albedo, *to.mutable_albedo());
  to.set_cpu_seconds(from.cpu_seconds);
}

}  // namespace

v1::FitProgress to_wire(const fit::Progress& progress) {
  v1::FitProgress to;
  to.set_stage(std::string(progress.stage));
  to.set_iteration(progress.iteration);
  to.set_objective(progress.objective);
  to.set_best(progress.best);
  return to;
}

v1::FitResult to_wire(const fit::FitResult& result) {
  v1::FitResult to;
  *to.mutable_material() = to_wire(result.material);
  fill(result.certificate, *to.mutable_certificate());
  return to;
}

}  // namespace gonio::server
