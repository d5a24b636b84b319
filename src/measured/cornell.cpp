#include <cmath>
#include <span>

#include "base/text/encoding.h"
#include "measured/pairs.h"
#include "measured/text_file.h"

namespace gonio {
namespace {

constexpr int kMostWavelengths = 64;
constexpr std::ptrdiff_t kAngles = 4;  // of a row, before its values

void push_direction(double theta, double phi, std::vector<double>& to) {
  const double s = std::sin(theta);
  to.insert(to.end(), {s * std::cos(phi), s * std::sin(phi), std::cos(theta)});
}

// Count and wavelengths may stand on one line or on several.
Result<int> read_head(TextRows& rows) {
  const auto count = rows.number("the number of wavelengths");
  if (!count) return count.error();
  if (!(*count >= 1 && *count <= kMostWavelengths) || *count != std::floor(*count)) {
    return rows.error(std::to_string(*count) + " wavelengths",
                      "a whole number from 1 to " + std::to_string(kMostWavelengths));
  }
  for (int i = 0; i < static_cast<int>(*count); ++i) {
    const auto wavelength = rows.number("a wavelength in nm");
    if (!wavelength) return wavelength.error();
    if (!(*wavelength > 0) || std::isinf(*wavelength))
      return rows.error(std::to_string(*wavelength), "a wavelength in nm");
  }
  return static_cast<int>(*count);
}

void push_row(std::span<const double> row, MeasuredPairs& pairs) {
  push_direction(row[0], row[1], pairs.wi);
  push_direction(row[2], row[3], pairs.wo);
  pairs.values.insert(pairs.values.end(), row.begin() + kAngles, row.end());
}

}  // namespace

Result<MeasuredPairs> parse_cornell(std::string_view text, const std::string& name) {
  const auto plain = utf8_text(text, name);
  if (!plain) return plain.error();
  TextRows rows(*plain, name);
  const auto channels = read_head(rows);
  if (!channels) return channels.error();
  MeasuredPairs pairs;
  pairs.channels = *channels;
  std::vector<double> numbers(kAngles + static_cast<std::size_t>(*channels));
  const std::string what = "theta_i, phi_i, theta_s, phi_s in radians and a value for each of " +
                           std::to_string(*channels) + " wavelengths";
  for (;;) {
    const auto row = rows.row(numbers, what);
    if (!row) return row.error();
    if (!*row) break;
    push_row(numbers, pairs);
  }
  if (pairs.size() == 0) return rows.error("the end of the file", "rows of " + what);
  return pairs;
}

Result<MeasuredPairs> read_cornell(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return parse_cornell(*text, file.string());
}

}  // namespace gonio
