// Fits and comparisons as text for people. Thread safety: no state.
#pragma once

#include <string>
#include <vector>

#include "gonio/client/fit.h"

namespace gonio::cli {

// The head of the columns that error_cells() fills, in two lines that begin after `width`
// characters.
std::string error_head(std::size_t width);
// Each measure for all pairs, up to 80 degrees and above; "-" where there are no pairs.
std::string error_cells(const client::FitErrorsByZone& errors);

// "5 negative or not measured", a reason each.
std::vector<std::string> left_out_words(const client::FitLeftOut& out);
// "1234 pairs; left out: 5 negative or not measured"
std::string left_out_line(const client::FitCertificate& certificate);

struct NamedFit {
  std::string name;
  client::FitResult result;
};

// What was fitted to, a line a fit, and below each its parameters and the reason of its verdict.
std::string fit_table(const std::vector<NamedFit>& fits);

}  // namespace gonio::cli
