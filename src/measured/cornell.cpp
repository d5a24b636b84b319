#include <cmath>

#include "measured/pairs.h"
#include "measured/text_file.h"

namespace gonio {
namespace {

constexpr int kMostWavelengths = 64;

void push_direction(double theta, double phi, std::vector<double>& to) {
  const double s = std::sin(theta);
  to.insert(to.end(), {s * std::cos(phi), s * std::sin(phi), std::cos(theta)});
}

Result<int> read_head(TextWords& words) {
  const auto count = words.number("the number of wavelengths");
  if (!count) return count.error();
  if (!(*count >= 1 && *count <= kMostWavelengths) || *count != std::floor(*count)) {
    return words.error(std::to_string(*count) + " wavelengths",
                       "a whole number from 1 to " + std::to_string(kMostWavelengths));
  }
  for (int i = 0; i < static_cast<int>(*count); ++i) {
    const auto wavelength = words.number("a wavelength in nm");
    if (!wavelength) return wavelength.error();
  }
  return static_cast<int>(*count);
}

Outcome read_row(TextWords& words, MeasuredPairs& pairs) {
  double angles[4];
  for (double& angle : angles) {
    const auto number = words.number("an angle in radians");
    if (!number) return number.error();
    angle = *number;
  }
  push_direction(angles[0], angles[1], pairs.wi);
  push_direction(angles[2], angles[3], pairs.wo);
  for (int c = 0; c < pairs.channels; ++c) {
    const auto value = words.number("a value for each wavelength");
    if (!value) return value.error();
    pairs.values.push_back(*value);
  }
  return Ok{};
}

}  // namespace

Result<MeasuredPairs> parse_cornell(std::string_view text, const std::string& name) {
  TextWords words(text, name);
  const auto channels = read_head(words);
  if (!channels) return channels.error();
  MeasuredPairs pairs;
  pairs.channels = *channels;
  while (!words.at_end()) {
    if (auto row = read_row(words, pairs); !row) return row.error();
  }
  if (pairs.size() == 0) return words.error("the end of the file", "rows of measurements");
  return pairs;
}

Result<MeasuredPairs> read_cornell(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  return parse_cornell(*text, file.string());
}

}  // namespace gonio
