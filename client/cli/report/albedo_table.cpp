#include "client/cli/report/albedo_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

#include "client/cli/output/json.h"
#include "client/cli/output/numbers.h"

namespace gonio::cli {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

std::string fixed(const char* format, double number) {
  char text[64];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

std::string flag_words(std::uint8_t flags) {
  std::string words;
  for (std::size_t bit = 0; bit < client::kFlagBits; ++bit) {
    if (((flags >> bit) & 1U) == 0) continue;
    words += (words.empty() ? "" : ", ") + std::string(client::flag_meaning(bit));
  }
  return words;
}

// The albedo's columns: 4 decimals are what 65536 samples give, the errors show two digits.
std::string numbers_of(const client::Albedos& albedos, std::size_t i) {
  const auto channels = static_cast<std::size_t>(albedos.report.channels);
  std::string line;
  for (std::size_t c = 0; c < channels; ++c) {
    line += fixed("  %9.6f", albedos.albedo[i * channels + c]);
    line += fixed("  %8.2g", albedos.standard_error[i * channels + c]);
  }
  return line + fixed("  %8.3g", albedos.lost[i]);
}

std::string array_of(std::span<const double> numbers) {
  std::string json = "[";
  for (const double& number : numbers) {
    json += &number == numbers.data() ? "" : ", ";
    json += std::isfinite(number) ? shortest(number) : "null";  // JSON has no word for others
  }
  return json + "]";
}

}  // namespace

std::string albedo_text(const std::vector<double>& wi, const client::Albedos& albedos) {
  std::string text = "   theta      phi";
  for (int c = 0; c < albedos.report.channels; ++c) {
    text += fixed("   albedo_%-2.0f", c) + fixed("  error_%-2.0f", c);
  }
  const bool has_holes = std::ranges::any_of(albedos.holes, [](double x) { return x > 0; });
  text += has_holes ? "      lost     holes\n" : "      lost\n";
  for (std::size_t i = 0; i < albedos.lost.size(); ++i) {
    const double x = wi[3 * i], y = wi[3 * i + 1], z = wi[3 * i + 2];
    text += fixed("%8.3f", kDegrees * std::atan2(std::hypot(x, y), z));
    text += fixed(" %8.3f", kDegrees * std::atan2(y, x));
    const std::uint8_t flags = albedos.flags[i];
    text += flags == 0 ? numbers_of(albedos, i) : "  " + flag_words(flags);
    text += has_holes && flags == 0 ? fixed("  %8.3g\n", albedos.holes[i]) : "\n";
  }
  if (has_holes)
    text += "holes: the part of the hemisphere whose values the table has not measured\n";
  return text;
}

std::string albedo_json(const std::vector<double>& wi, const client::Albedos& albedos) {
  const auto channels = static_cast<std::size_t>(albedos.report.channels);
  std::string json = "{\"channels\": " + std::to_string(channels) + ",\n\"albedos\": [";
  for (std::size_t i = 0; i < albedos.lost.size(); ++i) {
    const auto of = [&](const std::vector<double>& all) {
      return array_of(std::span(all).subspan(i * channels, channels));
    };
    json += i == 0 ? "\n" : ",\n";
    json += "{\"wi\": " + array_of(std::span(wi).subspan(3 * i, 3)) +
            ", \"albedo\": " + of(albedos.albedo) +
            ", \"standard_error\": " + of(albedos.standard_error) +
            ", \"lost\": " + shortest(albedos.lost[i]) +
            ", \"holes\": " + shortest(albedos.holes[i]) +
            ", \"flags\": " + std::to_string(albedos.flags[i]) + "}";
  }
  return json + "\n],\n\"report\": " + report_json(albedos.report, true) + "}\n";
}

}  // namespace gonio::cli
