#include "client/messages/fit_convert.h"

#include <utility>
#include <vector>

#include "client/messages/message_json.h"
#include "client/messages/repeated.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

Verdict verdict_of(v1::FitVerdict verdict) {
  switch (verdict) {
    case v1::FIT_VERDICT_CONVERGED:
      return Verdict::converged;
    case v1::FIT_VERDICT_BOUND_LIMITED:
      return Verdict::bound_limited;
    case v1::FIT_VERDICT_AMBIGUOUS:
      return Verdict::ambiguous;
    case v1::FIT_VERDICT_FAILED:
      return Verdict::failed;
    default:
      return Verdict::unknown;
  }
}

FitLeftOut left_out_of(const v1::FitLeftOut& from) {
  return {from.not_finite(), from.not_unit(), from.below_horizon(), from.negative(),
          from.no_weight()};
}

FitStage stage_of(const v1::FitStage& from) {
  return {from.name(), from.objective(), from.pairs(), from.iterations(), from.cpu_seconds()};
}

FitStart start_of(const v1::FitStart& from) {
  return {from.given(), list<double>(from.from()), list<double>(from.to()), from.objective(),
          from.agrees()};
}

FitParameter parameter_of(const v1::FitParameter& from) {
  return {from.field(),    from.channel(), from.value(), from.standard_error(),
          from.at_bound(), from.lower(),   from.upper(), from.undetermined()};
}

FitIndistinct indistinct_of(const v1::FitIndistinct& from) {
  return {list<std::string>(from.fields()), from.eigenvalue()};
}

FitProfile profile_of(const v1::FitProfile& from) {
  return {from.field(), from.lower(), from.upper(), from.part(), from.separate()};
}

FitErrors errors_of(const v1::FitErrors& from) {
  return {from.l1(), from.rmse(), from.log(), from.cbrt(), from.pairs()};
}

FitPlace place_of(const v1::FitPlace& from) {
  return {direction_of(from.wi()), direction_of(from.wo()), from.channel(),
          from.measured(),         from.fitted(),           from.share()};
}

FitRegion region_of(const v1::FitRegion& from) {
  return {from.measured(), from.fitted(), from.error()};
}

FitAlbedo albedo_of(const v1::FitAlbedo& from) {
  return {from.theta(), list<double>(from.channels())};
}

FitCertificate certificate_of(const v1::FitCertificate& from) {
  FitCertificate to;
  to.verdict = verdict_of(from.verdict());
  to.reason = from.reason();
  to.pairs = from.pairs();
  to.left_out = left_out_of(from.left_out());
  to.stages = all(from.stages(), stage_of);
  to.shapes = list<std::string>(from.shapes());
  to.starts = all(from.starts(), start_of);
  to.agreeing = from.agreeing();
  to.gradient_norm = from.gradient_norm();
  to.parameters = all(from.parameters(), parameter_of);
  to.active_bounds = list<std::string>(from.active_bounds());
  to.indistinct = all(from.indistinct(), indistinct_of);
  to.profiles = all(from.profiles(), profile_of);
  to.errors = {errors_of(from.errors().all()), errors_of(from.errors().below_80()),
               errors_of(from.errors().above_80())};
  to.worst = all(from.worst(), place_of);
  to.mirror = region_of(from.regions().mirror());
  to.toward_light = region_of(from.regions().toward_light());
  to.elsewhere = region_of(from.regions().elsewhere());
  to.albedo = all(from.albedo(), albedo_of);
  to.cpu_seconds = from.cpu_seconds();
  return to;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::converged:
      return "converged";
    case Verdict::bound_limited:
      return "bound-limited";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::failed:
      return "failed";
    case Verdict::unknown:
      break;
  }
  return "unknown";
}

FitProgress progress_of(const gonio::v1::FitProgress& progress) {
  return {progress.stage(), progress.iteration(), progress.objective(), progress.best()};
}

Result<FitResult> fit_result_of(const gonio::v1::FitResult& result) {
  auto material = material_of(result.material());
  if (!material) return material.error();
  auto json = json_of(result);
  if (!json) return json.error();
  return FitResult{std::move(*material), certificate_of(result.certificate()), std::move(*json)};
}

}  // namespace gonio::client
