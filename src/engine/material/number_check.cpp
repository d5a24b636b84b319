#include "engine/material/number_check.h"

#include <algorithm>
#include <charconv>
#include <numbers>

namespace gonio {
namespace {

std::string text_of(double number) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), number).ptr;
  return {buffer, end};
}

std::string bounds_of(const Parameter& p) {
  return "[" + text_of(p.lower) + ", " + text_of(p.upper) + "]";
}

// An angle far beyond its range that would do in degrees was meant in them.
std::string degrees_hint(const Parameter& p, double number) {
  const double radians = number * std::numbers::pi / 180;
  const bool meant = p.unit == "rad" && number > 2 * p.upper && radians <= p.upper;
  return meant ? " in radians: " + text_of(number) + " degrees are " + text_of(radians) : "";
}

std::string allowed_instead_of_word(const Parameter& p) {
  std::string allowed = "a number in " + bounds_of(p);
  for (const Preset& preset : p.presets) {
    allowed += &preset == p.presets.data() ? ", or one of " : ", ";
    allowed += preset.name;
  }
  return allowed;
}

Result<std::vector<double>> numbers_of(const std::string& field, const Parameter& p,
                                       const ParameterValue& given) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&given)) return *numbers;
  const auto& word = std::get<std::string>(given);
  const auto found = std::find_if(p.presets.begin(), p.presets.end(),
                                  [&](const Preset& preset) { return preset.name == word; });
  if (found == p.presets.end())
    return bad_value(field, '"' + word + '"', allowed_instead_of_word(p));
  return std::vector<double>(found->rgb.begin(), found->rgb.end());
}

Outcome check_length(const std::string& field, const Parameter& p, std::size_t length,
                     ChannelCount& channels) {
  const auto count = static_cast<std::size_t>(channels.count);
  if (length == 1) return Ok{};
  const std::string given = std::to_string(length) + " numbers";
  if (p.type != ParameterType::colour) return bad_value(field, given, "one number");
  if (length == 0) return bad_value(field, "empty", "one number, or one per channel");
  if (length > static_cast<std::size_t>(kMaxChannels)) {
    return bad_value(field, given, "at most " + std::to_string(kMaxChannels) + " channels");
  }
  if (count != 1 && length != count) {
    return bad_value(field, given,
                     "1 or " + std::to_string(count) + ", as " + channels.set_by + " has");
  }
  channels = {static_cast<int>(length), field};
  return Ok{};
}

}  // namespace

Result<std::vector<double>> check_numbers(const std::string& field, const Parameter& p,
                                          const ParameterValue& given, ChannelCount& channels) {
  Result<std::vector<double>> numbers = numbers_of(field, p, given);
  if (!numbers) return numbers;
  if (Outcome length = check_length(field, p, numbers->size(), channels); !length)
    return length.error();
  for (std::size_t i = 0; i < numbers->size(); ++i) {
    const double number = (*numbers)[i];
    if (number >= p.lower && number <= p.upper) continue;  // false for NaN
    return bad_value(numbers->size() == 1 ? field : field + "[" + std::to_string(i) + "]",
                     text_of(number), bounds_of(p) + degrees_hint(p, number));
  }
  return numbers;
}

}  // namespace gonio
