#include "client/cli/report/fit_page.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/text/join.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

using client::FitCertificate;

constexpr double kDegrees = 180 / std::numbers::pi;

std::string number(double x, const char* format = "%.4g") {
  char text[32];
  std::snprintf(text, sizeof(text), format, x);
  return text;
}

// The L1 error of a zone.
std::string l1_of(const client::FitErrors& errors) {
  return errors.pairs == 0 ? "no pairs" : number(errors.l1);
}

std::string row(const std::vector<std::string>& cells) {
  return "| " + joined(cells, " | ") + " |\n";
}

std::string head(const std::vector<std::string>& names) {
  return "\n" + row(names) + row(std::vector<std::string>(names.size(), "---"));
}

std::string numbers(const std::vector<double>& values) {
  std::vector<std::string> words;
  for (const double value : values) words.push_back(number(value));
  return joined(words, ", ");
}

std::string zone(const char* name, const client::FitErrors& errors) {
  if (errors.pairs == 0) return row({name, "no pairs", "-", "-", "-", "-"});
  return row({name, std::to_string(errors.pairs), number(errors.l1), number(errors.rmse),
              number(errors.log), number(errors.cbrt)});
}

std::string errors_of(const FitCertificate& certificate) {
  return "\nErrors over all data, by the larger of both angles:\n" +
         head({"zone", "pairs", "L1", "RMSE in 1/sr", "LOG", "CBRT"}) +
         zone("all", certificate.errors.all) + zone("up to 80°", certificate.errors.below_80) +
         zone("above 80°", certificate.errors.above_80);
}

std::string parameters_of(const FitCertificate& certificate) {
  std::string text = "\nParameters:\n" +
                     head({"parameter", "channel", "value", "standard error", "95 % interval"});
  for (const auto& parameter : certificate.parameters) {
    const std::string channel = parameter.channel < 0 ? "all" : std::to_string(parameter.channel);
    const std::string error = parameter.at_bound       ? "at its bound"
                              : parameter.undetermined ? "not determined"
                                                       : number(parameter.standard_error, "%.2g");
    const std::string interval =
        parameter.at_bound ? "-" : number(parameter.lower) + " to " + number(parameter.upper);
    text += row(
        {"`" + parameter.field + "`", channel, number(parameter.value, "%.6g"), error, interval});
  }
  return text;
}

std::string doubts_of(const FitCertificate& certificate) {
  std::string text;
  for (const auto& indistinct : certificate.indistinct) {
    const std::string correlation =
        indistinct.correlation ? ", correlation " + number(*indistinct.correlation) : "";
    text += "- The data hardly tell apart: " + joined(indistinct.fields, ", ") + " (eigenvalue " +
            number(indistinct.eigenvalue, "%.2g") + correlation + ").\n";
  }
  for (const auto& profile : certificate.profiles) {
    text += "- `" + profile.field + "` can be from " + number(profile.lower) + " to " +
            number(profile.upper) + " within 1 % of the objective, " +
            number(100 * profile.part, "%.2g") + " % of its range" +
            (profile.separate ? ", in places that are apart" : "") + ".\n";
  }
  if (!certificate.active_bounds.empty())
    text += "- At a bound: " + joined(certificate.active_bounds, ", ") + ".\n";
  if (!certificate.indistinct.empty()) {
    text +=
        "\nAn eigenvalue is one of the curvature scaled to a unit diagonal; for two numbers whose "
        "estimates go together, 1 - |correlation|.\n";
  }
  return text.empty() ? text : "\nWhat is not certain:\n\n" + text;
}

std::string search_of(const FitCertificate& certificate) {
  const std::string minimising =
      certificate.objective ? ", minimising " + std::string(name_of(*certificate.objective)) : "";
  std::string text = "\nHow it was found" + minimising +
                     " (objectives as parts of that of f = 0):\n" +
                     head({"stage", "objective", "pairs", "iterations", "CPU s"});
  for (const auto& stage : certificate.stages) {
    text += row({stage.name, number(stage.objective, "%.6g"), std::to_string(stage.pairs),
                 std::to_string(stage.iterations), number(stage.cpu_seconds, "%.3g")});
  }
  if (certificate.starts.empty()) return text;
  text += "\n" + std::to_string(certificate.agreeing) + " of " +
          std::to_string(certificate.starts.size()) +
          " starts end within 1 % of the best; gradient norm at the end " +
          number(certificate.gradient_norm, "%.2g") + ".\n" +
          head({"from " + joined(certificate.shapes, ", "), "to", "objective", "agrees"});
  for (const auto& start : certificate.starts) {
    text += row({numbers(start.from) + (start.given ? " (the guess)" : ""), numbers(start.to),
                 number(start.objective, "%.6g"), start.agrees ? "yes" : "no"});
  }
  return text;
}

std::string angles(const std::array<double, 3>& direction) {
  const double theta = std::atan2(std::hypot(direction[0], direction[1]), direction[2]);
  return number(theta * kDegrees, "%.1f") + "°, " +
         number(std::atan2(direction[1], direction[0]) * kDegrees, "%.1f") + "°";
}

std::string region(const char* name, const client::FitRegion& region) {
  return row({name, number(region.measured, "%.3g"), number(region.fitted, "%.3g"),
              number(region.error, "%.3g")});
}

std::string misfit_of(const FitCertificate& certificate) {
  std::string text = "\nWhere it reflects, as parts of all that is measured:\n" +
                     head({"where", "measured", "fitted", "error"}) +
                     region("within 25° of the mirror direction", certificate.regions.mirror) +
                     region("so near to the light", certificate.regions.toward_light) +
                     region("elsewhere", certificate.regions.elsewhere);
  if (certificate.worst.empty()) return text;
  text += "\nThe worst places:\n" +
          head({"θᵢ, φᵢ", "θₒ, φₒ", "channel", "measured in 1/sr", "fitted", "share of the error"});
  for (const auto& place : certificate.worst) {
    text += row({angles(place.wi), angles(place.wo), std::to_string(place.channel),
                 number(place.measured), number(place.fitted), number(place.share, "%.2g")});
  }
  return text;
}

std::string albedo_of(const FitCertificate& certificate) {
  if (certificate.albedo.empty()) return {};
  std::string text = "\nAlbedo of the material:\n" + head({"θᵢ", "by channel"});
  for (const auto& albedo : certificate.albedo)
    text += row({number(albedo.theta * kDegrees, "%.1f") + "°", numbers(albedo.channels)});
  return text;
}

std::string section(const NamedFit& fit) {
  const FitCertificate& certificate = fit.result.certificate;
  return "\n## " + fit.name + ": " + std::string(name_of(certificate.verdict)) + "\n\n" +
         certificate.reason + "\n\n```json\n" + fit.result.material.to_json() + "\n```\n" +
         errors_of(certificate) + parameters_of(certificate) + doubts_of(certificate) +
         search_of(certificate) + misfit_of(certificate) + albedo_of(certificate) +
         "\nThe fit took " + number(certificate.cpu_seconds, "%.3g") + " s of one processor.\n";
}

std::string how(const FitArguments& arguments) {
  return "Objective " + arguments.objective + ", strategy " + arguments.strategy +
         ", pairs above " + number(arguments.min_theta) + "° and up to " +
         number(arguments.max_theta) + "°, " + std::to_string(arguments.starts) + " starts, seed " +
         std::to_string(arguments.seed) + (arguments.anisotropic ? ", anisotropic" : "") +
         (arguments.rotation ? ", turned by " + number(*arguments.rotation) + "°" : "") +
         (arguments.polish ? ", with a last descent on all pairs" : "") + ".\n";
}

}  // namespace

std::string fit_page(const std::vector<NamedFit>& fits, const FitArguments& arguments) {
  std::string text = "# Fits to " + shown(arguments.data) + "\n\n" + how(arguments);
  if (!fits.empty()) text += "\n" + left_out_line(fits.front().result.certificate) + ".\n";
  text += head({"model", "verdict", "L1 all", "L1 up to 80°", "L1 above 80°", "CPU s"});
  for (const NamedFit& fit : fits) {
    const FitCertificate& certificate = fit.result.certificate;
    const auto& errors = certificate.errors;
    text += row({fit.name, std::string(name_of(certificate.verdict)), l1_of(errors.all),
                 l1_of(errors.below_80), l1_of(errors.above_80),
                 number(certificate.cpu_seconds, "%.3g")});
  }
  for (const NamedFit& fit : fits) text += section(fit);
  return text;
}

}  // namespace gonio::cli
