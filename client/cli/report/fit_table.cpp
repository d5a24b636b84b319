#include "client/cli/report/fit_table.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/text/join.h"
#include "client/cli/output/text.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kCell = 9;
constexpr std::array<double client::FitErrors::*, 4> kMeasures{
    &client::FitErrors::l1, &client::FitErrors::rmse, &client::FitErrors::log,
    &client::FitErrors::cbrt};

std::string number(double x, const char* format = "%.3g") {
  char text[32];
  std::snprintf(text, sizeof(text), format, x);
  return text;
}

std::string cell(const client::FitErrors& errors, double client::FitErrors::*measure) {
  return padded(errors.pairs == 0 ? "-" : number(errors.*measure), kCell);
}

// "specular[0].parameters.alpha_x" as "specular[0].alpha_x".
std::string short_field(std::string field) {
  constexpr std::string_view kMiddle = "parameters.";
  const std::size_t at = field.find(kMiddle);
  if (at != std::string::npos) field.erase(at, kMiddle.size());
  return field;
}

std::string uncertain(const client::FitParameter& parameter) {
  const std::string text = number(parameter.value, "%.4g");
  if (parameter.at_bound) return text + " (at its bound)";
  if (parameter.undetermined) return text + " (not determined)";
  return text + " +- " + number(parameter.standard_error, "%.2g");
}

// The channels of one colour stand together, the first three of them.
std::vector<std::string> parameter_words(const std::vector<client::FitParameter>& parameters) {
  constexpr std::size_t kShown = 3;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < parameters.size();) {
    std::string text = short_field(parameters[i].field) + " " + uncertain(parameters[i]);
    std::size_t end = i + 1;
    while (end < parameters.size() && parameters[end].field == parameters[i].field) ++end;
    for (std::size_t c = i + 1; c < std::min(end, i + kShown); ++c)
      text += " / " + uncertain(parameters[c]);
    if (end > i + kShown) text += " / ... (" + std::to_string(end - i) + " channels)";
    words.push_back(text);
    i = end;
  }
  return words;
}

}  // namespace

std::vector<std::string> left_out_words(const client::FitLeftOut& out) {
  std::vector<std::string> words;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) words.push_back(std::to_string(count) + " " + what);
  };
  add(out.not_finite, "not finite");
  add(out.not_unit, "not unit");
  add(out.below_horizon, "below the horizon");
  add(out.negative, "negative or not measured");
  add(out.no_weight, "without weight");
  return words;
}

std::string left_out_line(const client::FitCertificate& certificate) {
  const std::vector<std::string> words = left_out_words(certificate.left_out);
  const std::string line = std::to_string(certificate.pairs) + " pairs";
  return words.empty() ? line : line + "; left out: " + joined(words, ", ");
}

std::string error_head(std::size_t width) {
  std::string measures(width, ' '), zones(width, ' ');
  for (const char* name : {"L1", "RMSE", "LOG", "CBRT"}) {
    measures += padded(name, 3 * kCell);
    zones += padded("all", kCell) + padded("<=80", kCell) + padded(">80", kCell);
  }
  return measures + "\n" + zones;
}

std::string error_cells(const client::FitErrorsByZone& errors) {
  std::string text;
  for (const auto measure : kMeasures) {
    text +=
        cell(errors.all, measure) + cell(errors.below_80, measure) + cell(errors.above_80, measure);
  }
  return text;
}

std::string fit_table(const std::vector<NamedFit>& fits) {
  constexpr std::size_t kName = 28, kVerdict = 15;
  std::string text;
  if (!fits.empty()) text = left_out_line(fits.front().result.certificate) + "\n\n";
  text += error_head(kName + kVerdict) + "CPU s\n";
  for (const auto& [name, result] : fits) {
    const client::FitCertificate& certificate = result.certificate;
    text += padded(name, kName) + padded(name_of(certificate.verdict), kVerdict) +
            error_cells(certificate.errors) + number(certificate.cpu_seconds) + "\n";
    const std::string parameters = joined(parameter_words(certificate.parameters), ", ");
    if (!parameters.empty()) text += "    " + wrapped(parameters, 4) + "\n";
    text += "    " + wrapped(certificate.reason, 4) + "\n";
  }
  return text;
}

}  // namespace gonio::cli
