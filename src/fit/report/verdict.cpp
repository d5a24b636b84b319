#include "fit/report/verdict.h"

#include <cmath>

#include "fit/report/reasons.h"
#include "fit/report/substance.h"

namespace gonio::fit {
namespace {

// Light that is measured where no lobe of these models can be.
Reason not_the_model(const Certificate& report) {
  const Region& light = report.regions.toward_light;
  constexpr double kCounts = 0.05, kMissed = 0.5;
  const double missing = light.measured - light.fitted;
  if (light.measured > kCounts && missing > kMissed * light.measured) {
    return "the data have a lobe toward the light (retro-reflection) that the model has not: " +
           percent(missing) + " of what is measured is missing there";
  }
  if (!std::isfinite(report.errors.all.l1)) return "the errors are not finite";
  return {};
}

// Verdict and reason, but for hints.
void decide(const Form& form, std::span<const double> parameters, const Data& fitted,
            Certificate& report) {
  const auto take = [&](Verdict verdict, const Reason& reason) {
    if (!reason || !report.reason.empty()) return;
    report.verdict = verdict;
    report.reason = *reason;
  };
  take(Verdict::failed, not_the_model(report));
  take(Verdict::bound_limited, too_dark(form, report));
  take(Verdict::ambiguous, ambiguity(form, parameters, fitted, report));
  take(Verdict::bound_limited, held(form, report));
  take(Verdict::ambiguous, vagueness(report));
  if (!report.reason.empty()) return;
  report.verdict = Verdict::converged;
  report.reason = std::to_string(report.agreeing) + " of " + std::to_string(report.starts.size()) +
                  " starts end within 1 % of the best, inside all bounds";
}

}  // namespace

void set_verdict(const Form& form, std::span<const double> parameters, const Data& fitted,
                 Certificate& report) {
  decide(form, parameters, fitted, report);
  if (const auto hint = substance_hint(form, report)) report.reason += "; " + *hint;
}

}  // namespace gonio::fit
