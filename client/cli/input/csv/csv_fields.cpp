#include "client/cli/input/csv/csv_fields.h"

namespace gonio::cli {

void CsvFields::take_quoted(std::string_view& field) {
  constexpr std::size_t kNone = std::string_view::npos;
  const std::size_t open = rest_.find('"');
  std::size_t close = rest_.find('"', open + 1);
  while (close != kNone && close + 1 < rest_.size() && rest_[close + 1] == '"')
    close = rest_.find('"', close + 2);
  if (close == kNone) {
    field = rest_.substr(open);
    badly_quoted_ = true;
    more_ = false;
    return;
  }
  field = trimmed(rest_.substr(open + 1, close - open - 1));
  const std::string_view behind = rest_.substr(close + 1);
  const std::size_t end = end_of_field(behind);
  if (!trimmed(behind.substr(0, end)).empty()) badly_quoted_ = true;
  go_on(behind, end);
}

}  // namespace gonio::cli
