// From findings and limits to a verdict. Thread safety: functions without state.
#pragma once

#include "assess/assess.h"

namespace gonio::assess {

// Errors: a limit that is negative, NaN or out of range, with its field.
Outcome check_options(const Options& options);

// Fills report.checks and report.passed from the rest of it.
void set_verdict(const Limits& limits, Report& report);

}  // namespace gonio::assess
