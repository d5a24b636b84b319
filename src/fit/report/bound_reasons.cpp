#include <algorithm>
#include <vector>

#include "base/text/join.h"
#include "fit/report/reasons.h"

namespace gonio::fit {
namespace {

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

}  // namespace

Reason too_dark(const Form& form, const Certificate& report) {
  const ColourBoundNames names(form);
  std::vector<std::string> fields;
  for (const std::string& bound : report.active_bounds) {
    if (contains(names.lobe_upper, bound)) fields.push_back(bound);
  }
  return at_bound(fields);
}

Reason held(const Form& form, const Certificate& report) {
  const ColourBoundNames names(form);
  std::vector<std::string> fields;
  for (const std::string& bound : report.active_bounds) {
    if (!contains(names.lower, bound)) fields.push_back(bound);
  }
  return at_bound(fields);
}

}  // namespace gonio::fit
