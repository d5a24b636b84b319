// What may be wrong with an optimum, each in words that a certificate gives as its reason; none
// where it is not so. Thread safety: functions without state.
#pragma once

#include <cstdio>
#include <optional>
#include <span>
#include <string>

#include "fit/data/data.h"
#include "fit/form.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

using Reason = std::optional<std::string>;

inline std::string with_digits(double x, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}
inline std::string percent(double part) { return with_digits(100 * part, 3) + " %"; }

// The data want more light than the model's table allows, whatever its shapes.
Reason too_dark(const Form& form, const Certificate& report);
// Another bound holds the optimum. A colour of zero is one like any other.
Reason held(const Form& form, const Certificate& report);

// The data do not tell the parameters apart: each way in which that shows, the plainest first.
Reason ambiguity(const Form& form, std::span<const double> parameters, const Data& fitted,
                 const Certificate& report);
// The same of what matters only where no bound holds the optimum.
Reason vagueness(const Certificate& report);

}  // namespace gonio::fit
