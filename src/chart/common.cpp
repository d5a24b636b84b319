#include "chart/common.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gonio::chart {

Error was_cancelled() { return {ErrorCode::cancelled, "the chart was cancelled", {}, {}, {}}; }

ErrorStatistics statistics_of(assess::ErrorList errors) {
  auto& all = errors.relative;
  const double none = std::numeric_limits<double>::quiet_NaN();
  ErrorStatistics statistics{none, none, none, static_cast<double>(all.size()),
                             static_cast<double>(errors.improper)};
  if (all.empty()) return statistics;
  std::ranges::sort(all);
  const auto at = [&all](double part) {
    const double last = static_cast<double>(all.size() - 1);
    return all[static_cast<std::size_t>(std::ceil(part * last))];
  };
  statistics.worst = all.back();
  statistics.p999 = at(0.999);
  statistics.median = at(0.5);
  return statistics;
}

void add_error_columns(Table& table) {
  table.columns.push_back({"error_worst", "1", "the largest relative error of proper values"});
  table.columns.push_back({"error_999", "1", "the 99.9th percentile"});
  table.columns.push_back({"error_median", "1", "the median"});
  table.columns.push_back({"checked", "1", "how many values were compared"});
  table.columns.push_back({"improper", "1", "values that are NaN, infinite or negative"});
}

void add_error_cells(std::vector<Cell>& row, const ErrorStatistics& errors) {
  for (const double x : {errors.worst, errors.p999, errors.median, errors.checked, errors.improper})
    row.emplace_back(x);
}

}  // namespace gonio::chart
