#include "select/explain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "fit/report/metrics.h"
#include "select/error/error.h"

namespace gonio::select {
namespace {

constexpr std::array kLimits{0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0};  // degrees

std::string number(const char* format, double x) {
  char text[64];
  std::snprintf(text, sizeof(text), format, x);
  return text;
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

double largest_angle(const Scene& scene) {
  double largest = 0;
  for (const Bin& bin : scene.bins)
    largest = std::max({largest, bin.theta_i.upper, bin.theta_o.upper});
  return largest;
}

// The share of the error from pairs whose larger angle is between two limits, and the error of all
// pairs below the upper limit.
struct Band {
  double lower, upper;  // degrees
  double share;
  Bounded within;
  std::size_t pairs_within;
};

Blocks within(const Blocks& blocks, double degrees) {
  Blocks inner = blocks;
  for (fit::Data& part : inner.parts) part = fit::within(part, 0, radians(degrees));
  return inner;
}

std::vector<Band> bands_of(const Material& material, const Blocks& blocks, const Scene& scene) {
  double all = 0, before = 0;
  for (const Ratio& block : errors_of(material, blocks, scene.metric)) all += block.numerator;
  std::vector<Band> bands;
  for (std::size_t i = 1; i < kLimits.size(); ++i) {
    // The last band has no upper limit: pairs on the scene's edge belong to it.
    const bool last = radians(kLimits[i]) >= largest_angle(scene) - 1e-9;
    const Blocks inner = last ? blocks : within(blocks, kLimits[i]);
    const auto errors = errors_of(material, inner, scene.metric);
    double sum = 0;
    for (const Ratio& block : errors) sum += block.numerator;
    std::size_t pairs = 0;
    for (const fit::Data& part : inner.parts) pairs += part.size();
    bands.push_back({kLimits[i - 1], kLimits[i], all > 0 ? (sum - before) / all : 0,
                     bounded(errors, scene.metric, kWorthTrying), pairs});
    before = sum;
    if (last) break;
  }
  return bands;
}

std::string where(const fit::Regions& regions) {
  const double mirror = regions.mirror.error, light = regions.toward_light.error,
               all = mirror + light + regions.elsewhere.error;
  if (mirror > 0.5 * all)
    return number(", %.0f %% of it about the mirror direction", 100 * mirror / all);
  if (light > 0.5 * all) return number(", %.0f %% of it toward the light", 100 * light / all);
  return "";
}

}  // namespace

std::string explain_miss(const Material& material, const fit::Data& data, const Scene& scene) {
  constexpr std::size_t kFewest = 200;  // pairs; a band with fewer is not reported
  const auto bands = bands_of(material, Blocks(data), scene);
  const Bounded& whole = bands.back().within;
  std::string text = number("errs by %.3g", whole.value);
  if (whole.value < scene.tolerance) text += number(", at most %.3g", whole.upper);
  text += where(fit::compare(material, data, 0).regions);
  const Band* good = nullptr;
  for (const Band& band : bands) {
    if (band.pairs_within >= kFewest && band.within.upper < scene.tolerance) good = &band;
  }
  if (good != nullptr && good != &bands.back()) {
    text += number("; for angles up to %.0f degrees it would do", good->upper) +
            number(" (%.3g)", good->within.value);
  }
  const auto worst = std::max_element(
      bands.begin(), bands.end(), [](const Band& a, const Band& b) { return a.share < b.share; });
  text += number("; %.0f %% of the error", 100 * worst->share) +
          number(" is where the larger angle is %.0f", worst->lower) +
          number(" to %.0f degrees", worst->upper);
  return text;
}

}  // namespace gonio::select
