#include "fit/report/verdict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/join.h"
#include "fit/report/substance.h"
#include "fit/search/rotation.h"
#include "fit/search/same_place.h"

namespace gonio::fit {
namespace {

using Reason = std::optional<std::string>;

constexpr double kNearly = 1.05;

std::string percent(double part) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * part);
  return text;
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

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

Reason at_bound(const std::vector<std::string>& fields) {
  if (fields.empty()) return {};
  return "at its bound: " + joined(fields);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The bounds of a form's colours as a report names them, "specular[0].parameters.scale (upper)".
struct ColourBoundNames {
  std::vector<std::string> lower, lobe_upper;  // of all; of what multiplies a whole lobe

  explicit ColourBoundNames(const Form& form) {
    for (const FormLobe& lobe : form.lobes) {
      for (const ColourMember member : lobe.colours.members()) {
        const std::string field = field_of(lobe.prefix, lobe.colours.parameter(member));
        lower.push_back(field + " (lower)");
        if (member == &Colour::scale) lobe_upper.push_back(field + " (upper)");
      }
    }
  }
};

// The data want more light than the model's table allows, whatever its shapes.
Reason too_dark(const Form& form, const Certificate& report) {
  const ColourBoundNames names(form);
  std::vector<std::string> fields;
  for (const std::string& bound : report.active_bounds) {
    if (contains(names.lobe_upper, bound)) fields.push_back(bound);
  }
  return at_bound(fields);
}

// A colour of zero is one like any other; the other bounds hold an optimum.
Reason held(const Form& form, const Certificate& report) {
  const ColourBoundNames names(form);
  std::vector<std::string> fields;
  for (const std::string& bound : report.active_bounds) {
    if (!contains(names.lower, bound)) fields.push_back(bound);
  }
  return at_bound(fields);
}

// Shapes of a lobe without height say nothing.
Reason invisible(const Form& form, std::span<const double> parameters, int channels) {
  for (const FormLobe& lobe : form.lobes) {
    double height = 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
      const std::size_t first = form.first_of(lobe, c);
      for (std::size_t k = 0; k < lobe.coefficient_count; ++k) height += parameters[first + k];
    }
    const auto index = static_cast<std::size_t>(&lobe - form.lobes.data());
    const bool has_shape = std::any_of(form.shapes.begin(), form.shapes.end(),
                                       [&](const ShapeParameter& s) { return s.lobe == index; });
    if (has_shape && !(height > 0))
      return "the lobe " + std::string(lobe.model->name) + " has no height: its shape is arbitrary";
  }
  return {};
}

// Starts that end nearly as low, but elsewhere: another sample of the material could prefer them.
Reason other_basin(const Form& form, const Certificate& report) {
  const auto best =
      std::min_element(report.starts.begin(), report.starts.end(),
                       [](const Start& a, const Start& b) { return a.objective < b.objective; });
  for (const Start& start : report.starts) {
    if (start.objective > kNearly * best->objective) continue;
    const auto difference = apart(form, best->to, start.to);
    if (!difference) continue;
    return "another optimum is worse by " + percent(start.objective / best->objective - 1) +
           " only: " + form.shapes[difference->shape].field + " at " + number(difference->at) +
           " and at " + number(difference->other);
  }
  return {};
}

Reason wide_profile(const Certificate& report) {
  constexpr double kWide = 0.25;  // of the range that is searched
  for (const Profile& profile : report.profiles) {
    if (profile.part <= kWide && !profile.separate) continue;
    return profile.field + " is not determined: from " + number(profile.lower) + " to " +
           number(profile.upper) + " the objective is within 1 % of the best" +
           (profile.separate ? ", with worse values in between" : "");
  }
  return {};
}

Reason unseen(const Certificate& report) {
  for (const Indistinct& direction : report.indistinct) {
    if (direction.correlation) continue;
    if (direction.fields.size() == 1) return direction.fields.front() + " is not determined";
    return "the data do not tell apart " + joined(direction.fields);
  }
  return {};
}

// The fields that go together with one, each once.
std::vector<std::string> partners_of(const std::string& field, const Certificate& report) {
  std::vector<std::string> partners;
  for (const Indistinct& together : report.indistinct) {
    const auto& fields = together.fields;
    if (std::find(fields.begin(), fields.end(), field) == fields.end()) continue;
    for (const std::string& other : fields) {
      const bool known = std::find(partners.begin(), partners.end(), other) != partners.end();
      if (other != field && !known) partners.push_back(other);
    }
  }
  return partners;
}

// Numbers of which the data say nothing, shapes and colours.
Reason undetermined(const Certificate& report) {
  std::vector<std::string> fields;
  for (const ParameterReport& p : report.parameters) {
    const bool known = std::find(fields.begin(), fields.end(), p.field) != fields.end();
    if (!p.determined && !p.at_bound && !known) fields.push_back(p.field);
  }
  if (fields.empty()) return {};
  return "not determined by the data: " + joined(fields);
}

// A shape whose interval is wider than a factor of two either way says little; so does a rotation
// whose 95 % interval is about 30 degrees wide.
bool is_vague(const ParameterReport& p) {
  if (p.field == kRotation.name) return p.standard_error > kVagueDegrees;
  return p.lower * 4 < p.upper && p.standard_error * 2 > p.value;
}

Reason vague(const Certificate& report) {
  for (const ParameterReport& p : report.parameters) {
    const bool shape =
        std::find(report.shapes.begin(), report.shapes.end(), p.field) != report.shapes.end();
    if (!shape || p.at_bound || !is_vague(p)) continue;
    const std::vector<std::string> partners = partners_of(p.field, report);
    return p.field + " is hardly determined: " + number(p.lower) + " to " + number(p.upper) +
           " at 95 %" + (partners.empty() ? "" : "; it goes together with " + joined(partners));
  }
  return {};
}

Reason too_few(const Form& form, const Data& fitted) {
  const std::size_t numbers = fitted.size() * static_cast<std::size_t>(fitted.channels);
  const std::size_t parameters = form.parameters(fitted.channels);
  if (numbers > parameters) return {};
  return std::to_string(numbers) + " measured numbers for " + std::to_string(parameters) +
         " parameters";
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
  take(Verdict::ambiguous, too_few(form, fitted));
  take(Verdict::ambiguous, invisible(form, parameters, fitted.channels));
  take(Verdict::ambiguous, other_basin(form, report));
  take(Verdict::ambiguous, wide_profile(report));
  take(Verdict::bound_limited, held(form, report));
  take(Verdict::ambiguous, unseen(report));
  take(Verdict::ambiguous, undetermined(report));
  take(Verdict::ambiguous, vague(report));
  if (!report.reason.empty()) return;
  report.verdict = Verdict::converged;
  report.reason = std::to_string(report.agreeing) + " of " + std::to_string(report.starts.size()) +
                  " starts end within 1 % of the best, inside all bounds";
}

}  // namespace

void judge(const Form& form, std::span<const double> parameters, const Data& fitted,
           Certificate& report) {
  decide(form, parameters, fitted, report);
  if (const auto hint = substance_hint(form, report)) report.reason += "; " + *hint;
}

}  // namespace gonio::fit
