#include "client/cli/report/assess_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/text/join.h"
#include "client/cli/output/text.h"

namespace gonio::cli {
namespace {

constexpr std::size_t kName = 18, kCount = 9, kCell = 11, kNaive = 28;

std::string number(double x, const char* format = "%.2g") {
  char text[32];
  std::snprintf(text, sizeof(text), format, x);
  return text;
}

std::string count_of(std::uint64_t n) { return n == 0 ? "-" : std::to_string(n); }

std::uint64_t bad_of(const client::AssessFindings& f) {
  return f.nan + f.infinite + f.negative + f.stray;
}

std::string error_of(const client::AssessFindings& f) {
  return f.checked == 0 ? "-" : number(f.worst.error);
}

// "0.012, 231 NaN, 293 < 0"
std::string naive_of(const std::optional<client::AssessFindings>& naive) {
  if (!naive) return "not known";
  std::vector<std::string> words;
  if (naive->checked > 0) words.push_back(number(naive->worst.error));
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) words.push_back(std::to_string(count) + what);
  };
  add(naive->nan, " NaN");
  add(naive->infinite, " inf");
  add(naive->negative, " < 0");
  add(naive->stray, " stray");
  return words.empty() ? "-" : joined(words, ", ");
}

// "theta 45.2, phi 120", in degrees; the elevation where the angle is nearly 90.
std::string angles_of(const std::array<double, 3>& w) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const double theta = std::atan2(std::hypot(w[0], w[1]), w[2]) * kDegrees;
  return "theta " + number(theta, "%.8g") + " phi " +
         number(std::atan2(w[1], w[0]) * kDegrees, "%.6g");
}

std::string place_of(const client::AssessWorst& worst) {
  return "wi " + angles_of(worst.wi) + ", wo " + angles_of(worst.wo) + ", channel " +
         std::to_string(worst.channel) + ": " + number(worst.value, "%.9g") + ", not " +
         number(worst.truth, "%.9g");
}

std::string places_table(const client::Assessment& assessment, bool verbose) {
  std::string text = std::string(kName + kCount + kCount, ' ') +
                     padded("worst relative error", 3 * kCell) +
                     "naive arithmetic, the same float32 directions\n" + padded("place", kName) +
                     padded("pairs", kCount) + padded("bad", kCount) + padded("fast", kCell) +
                     padded("reference", kCell) + padded("reciprocal", kCell) +
                     padded("float32", kNaive) + "float64\n";
  for (const client::AssessPlace& place : assessment.places) {
    text += padded(place.name, kName) + padded(std::to_string(place.pairs), kCount) +
            padded(count_of(bad_of(place.fast) + bad_of(place.reference)), kCount) +
            padded(error_of(place.fast), kCell) + padded(error_of(place.reference), kCell) +
            padded(place.fast.checked == 0 ? "-" : number(place.reciprocity.error), kCell) +
            padded(naive_of(place.naive32), kNaive) + naive_of(place.naive64) + "\n";
    if (!verbose) continue;
    text += "    " + wrapped(place.where + "; naive: " + place.failure, 4) + "\n";
    if (place.fast.worst.error > 0)
      text += "    " + wrapped("worst at " + place_of(place.fast.worst), 4) + "\n";
  }
  return text;
}

// Of all channels: one number where they agree, else the range.
std::string range_of(const std::vector<double>& values) {
  if (values.empty()) return "-";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const std::string least = number(*low, "%.5f"), most = number(*high, "%.5f");
  return least == most ? least : least + " to " + most;
}

double farthest(const client::AssessIncidence& at) {
  double most = 0;
  for (std::size_t c = 0; c < std::min(at.sampled.size(), at.albedo.size()); ++c)
    most = std::max(most, std::abs(at.sampled[c] - at.albedo[c]));
  return most;
}

std::string incidences_table(const client::Assessment& assessment) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  constexpr std::size_t kAngle = 8, kAlbedo = 21, kEnergy = 10;
  std::string text = padded("theta", kAngle) + padded("phi", kAngle) + padded("albedo", kAlbedo) +
                     padded("gained", kEnergy) + padded("lost", kEnergy) +
                     padded("samples off", kCell + 2) + padded("pdf mass", kEnergy) +
                     padded("below", kEnergy) + padded("chi-square", kCell) + "weights off\n";
  for (const client::AssessIncidence& at : assessment.incidences) {
    const auto [low, high] = std::minmax_element(at.albedo.begin(), at.albedo.end());
    const double gained = at.albedo.empty() ? 0 : std::max(0.0, *high - 1);
    const double lost = at.albedo.empty() ? 0 : std::max(0.0, 1 - *low);
    text += padded(number(at.theta * kDegrees, "%.4g"), kAngle) +
            padded(number(at.phi * kDegrees, "%.4g"), kAngle) +
            padded(range_of(at.albedo), kAlbedo) +
            padded(gained > 0 ? number(gained, "%.5f") : "-", kEnergy) +
            padded(number(lost, "%.5f"), kEnergy) + padded(number(farthest(at)), kCell + 2) +
            padded(number(at.mass, "%.6f"), kEnergy) + padded(number(at.lost, "%.4f"), kEnergy) +
            padded(number(at.probability), kCell) + number(at.weight.error) + "\n";
  }
  return text;
}

std::string checks_table(const client::Assessment& assessment) {
  std::string text = padded("check", kName) + padded("worst", kCell) + padded("allowed", kCell) +
                     padded("", 8) + "at\n";
  for (const client::AssessCheck& check : assessment.checks) {
    text += padded(check.name, kName) + padded(number(check.value, "%.3g"), kCell) +
            padded(number(check.limit, "%.3g"), kCell) + padded(check.passed ? "ok" : "FAILED", 8) +
            check.where + "\n";
    if (!check.note.empty()) text += "    " + wrapped(check.note, 4) + "\n";
  }
  return text;
}

std::string verdict_of(const client::Assessment& assessment) {
  std::vector<std::string> failed;
  for (const client::AssessCheck& check : assessment.checks) {
    if (!check.passed) failed.push_back(check.name);
  }
  return assessment.passed ? "verdict: passed\n"
                           : "verdict: failed (" + joined(failed, ", ") + ")\n";
}

}  // namespace

std::string assess_table(const client::Assessment& assessment, bool verbose) {
  std::string text = std::to_string(assessment.channels) +
                     (assessment.channels == 1 ? " channel" : " channels") +
                     "; stated relative errors " + number(assessment.fast.relative) + " (fast), " +
                     number(assessment.reference.relative) + " (reference); " +
                     std::string(name_of(assessment.instruction_set)) + ", " +
                     number(assessment.cpu_seconds) + " s\n\n";
  return text + places_table(assessment, verbose) + "\n" + incidences_table(assessment) + "\n" +
         checks_table(assessment) + "\n" + verdict_of(assessment);
}

}  // namespace gonio::cli
