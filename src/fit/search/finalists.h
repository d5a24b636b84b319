// Which ends of descents on the scan's pairs go on with more pairs. Thread safety: functions
// without state.
#pragma once

#include <vector>

#include "fit/form.h"

namespace gonio::fit {

struct DescentEnd {
  std::vector<double> parameters;
  double objective;
  bool given;  // from the caller's guess?
};

// Of ends in rising order: the best distinct ones and, last, the guess's if it is another.
std::vector<DescentEnd> finalists(const Form& form, const std::vector<DescentEnd>& sorted);

}  // namespace gonio::fit
