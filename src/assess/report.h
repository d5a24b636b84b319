// What an assessment finds, with what only the core has of it. Thread safety: plain values.
#pragma once

#include <optional>

#include "assess/subject.h"
#include "gonio/assess/report.h"
#include "measured/merl/review.h"

namespace gonio::assess {

struct Report : Assessment {
  // Of a measured material. Its findings are in the checks, which travel; the review itself is what
  // the verdict is from.
  std::optional<TableReview> table;
};

}  // namespace gonio::assess
