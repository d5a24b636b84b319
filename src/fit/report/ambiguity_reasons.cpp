#include <algorithm>
#include <vector>

#include "base/text/join.h"
#include "fit/report/reasons.h"
#include "fit/search/rotation.h"
#include "fit/search/same_place.h"

namespace gonio::fit {
namespace {

// Objectives this close to the best could be the best of another sample of the material.
constexpr double kNearly = 1.05;

Reason too_few(const Form& form, const Data& fitted) {
  const std::size_t numbers = fitted.size() * static_cast<std::size_t>(fitted.channels);
  const std::size_t parameters = form.parameters(fitted.channels);
  if (numbers > parameters) return {};
  return std::to_string(numbers) + " measured numbers for " + std::to_string(parameters) +
         " parameters";
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
           " only: " + form.shapes[difference->shape].field + " at " +
           with_digits(difference->at, 4) + " and at " + with_digits(difference->other, 4);
  }
  return {};
}

Reason wide_profile(const Certificate& report) {
  constexpr double kWide = 0.25;  // of the range that is searched
  for (const Profile& profile : report.profiles) {
    if (profile.part <= kWide && !profile.separate) continue;
    return profile.field + " is not determined: from " + with_digits(profile.lower, 4) + " to " +
           with_digits(profile.upper, 4) + " the objective is within 1 % of the best" +
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
    if (p.undetermined && !p.at_bound && !known) fields.push_back(p.field);
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
    return p.field + " is hardly determined: " + with_digits(p.lower, 4) + " to " +
           with_digits(p.upper, 4) + " at 95 %" +
           (partners.empty() ? "" : "; it goes together with " + joined(partners));
  }
  return {};
}

// The first of them that is so.
Reason first_of(std::initializer_list<Reason> reasons) {
  for (const Reason& reason : reasons) {
    if (reason) return reason;
  }
  return {};
}

}  // namespace

Reason ambiguity(const Form& form, std::span<const double> parameters, const Data& fitted,
                 const Certificate& report) {
  return first_of({too_few(form, fitted), invisible(form, parameters, fitted.channels),
                   other_basin(form, report), wide_profile(report)});
}

Reason vagueness(const Certificate& report) {
  return first_of({unseen(report), undetermined(report), vague(report)});
}

}  // namespace gonio::fit
