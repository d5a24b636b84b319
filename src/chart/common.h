// Columns that several parts of a chart have. Thread safety: functions without state.
#pragma once

#include "assess/accuracy.h"
#include "chart/chart.h"

namespace gonio::chart {

inline bool is_over(const Options& options) { return options.stop && options.stop(); }
Error was_cancelled();
inline void show(const Options& options, double done) {
  if (options.progress) options.progress(done);
}

// Of relative errors; NaN where there are none.
struct ErrorStatistics {
  double worst, p999, median;
  double checked = 0, improper = 0;  // values
};
ErrorStatistics statistics_of(assess::ErrorList errors);

// "error_worst", "error_999", "error_median", "checked", "improper".
void add_error_columns(Table& table);
void add_error_cells(std::vector<Cell>& row, const ErrorStatistics& errors);

}  // namespace gonio::chart
