// What is said on standard error after an evaluation, or a drawing of samples. `items`: "pairs".
// Thread safety: no state.
#pragma once

#include <string>

#include "gonio/client/types.h"

namespace gonio::cli {

// "12 of 1000 pairs are flagged and have the value 0: 10 wi below the horizon, 2 not unit"; empty
// if there are none. Lost samples are among them.
std::string flag_summary(const client::Report& report, const std::string& items);

// "12 of 1000 pairs (1.2 %) met holes of the table, ..."; empty if none did.
std::string hole_summary(const client::Report& report, const std::string& items);

// "1000000 pairs x 3 channels in 0.021 s (47.6 M pairs/s); kernels 0.003 s; avx512, fast, relative
// error <= 3e-06 ..."
std::string report_line(const client::Report& report, const std::string& items, double seconds);

// "relative error <= 3e-06 where f > 1e-30", and the note if there is one.
std::string bound_text(const client::ErrorBound& bound);

// All on standard error: flags and holes unless `quiet`, the line if `verbose`.
void print_summary(const client::Report& report, const std::string& items, double seconds,
                   bool quiet, bool verbose);

}  // namespace gonio::cli
