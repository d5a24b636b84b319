#include "select/walk.h"

#include <cmath>
#include <cstdio>

#include "base/text/join.h"
#include "select/error/rounding.h"
#include "select/explain.h"

namespace gonio::select {
namespace {

constexpr double kFrontConfidence = 0.99;
constexpr double kShare = 0.01;  // of the tolerance: a difference that does not matter to a scene

std::string number(double x, int digits = 3) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.*g", digits, x);
  return text;
}

}  // namespace

Walk::Walk(const Scene& scene, const Sets& sets)
    : scene_(scene),
      sets_(sets),
      validation_(sets.validation),
      certification_(sets.certification) {}

void Walk::place_on_front(Tried& tried) {
  Entry& entry = tried.entry;
  if (!best_.empty()) {
    const Estimate difference = estimate_difference(tried.errors, best_);
    const double degrees = static_cast<double>(best_.size()) - 1;
    const double upper =
        difference.value + difference.standard_error * student_quantile(kFrontConfidence, degrees);
    const auto value = [this](const std::vector<Ratio>& errors) {
      return root_if_square(estimate(errors).value, scene_.metric);
    };
    const double gain = value(best_) - value(tried.errors);
    if (!(upper < 0 && gain > kShare * scene_.tolerance)) {
      entry.remark = "no better than " + best_name_;
      if (!entry.at_bounds.empty()) entry.remark += "; at a bound: " + joined(entry.at_bounds);
      return;
    }
  }
  entry.on_front = true;
  best_ = tried.errors;
  best_name_ = entry.name;
}

// The material rounded to the fewest digits that do not increase its error on the second set.
Choice Walk::rounded_choice(const Tried& tried, std::size_t index) const {
  Choice choice;
  choice.entry = index;
  choice.material = tried.entry.material;
  if (tried.entry.material) {
    const double most = tried.entry.error.value + kShare * scene_.tolerance;
    for (int digits = kFewestDigits; digits <= kMostDigits; ++digits) {
      const MaterialSpec spec = rounded(*tried.entry.material, digits);
      const auto material = Material::create(spec);
      if (!material) continue;
      const auto errors = errors_of(*material, validation_, scene_.metric);
      if (!(bounded(errors, scene_.metric, kWorthTrying).value <= most)) continue;
      choice.material = spec;
      choice.digits = static_cast<unsigned>(digits);
      break;
    }
  }
  return choice;
}

void Walk::certify(Tried& tried, std::size_t index) {
  Choice choice = rounded_choice(tried, index);
  const Material material =
      choice.digits > 0 ? *Material::create(*choice.material) : *tried.material;
  choice.confidence = 1 - (1 - scene_.confidence) * std::exp2(-static_cast<double>(++attempts_));
  choice.error =
      bounded(errors_of(material, certification_, scene_.metric), scene_.metric, choice.confidence);
  choice.pairs = sets_.certification.size();
  choice.float32_error = float32_error(material, certification_, scene_.metric);
  if (!(choice.error.upper < scene_.tolerance)) {
    tried.entry.remark = "its certificate failed: at most " + number(choice.error.upper);
    return;
  }
  choice.needs_float64 = !(choice.error.upper + choice.float32_error < scene_.tolerance);
  selection_.choice = std::move(choice);
}

void Walk::take(Tried tried) {
  const std::size_t index = selection_.entries.size();
  Entry& entry = tried.entry;
  entry.error = bounded(tried.errors, scene_.metric, kWorthTrying);
  entry.meets = entry.error.upper < scene_.tolerance;
  place_on_front(tried);
  if (!has_choice()) {
    // An anisotropic candidate that errs less only by chance is not chosen.
    if (entry.meets && (entry.on_front || !tried.anisotropic)) certify(tried, index);
    if (!has_choice()) {
      if (entry.remark.empty()) entry.remark = "misses the tolerance";
      if (entry.on_front) nearest_ = tried;
    }
  }
  selection_.entries.push_back(std::move(entry));
}

Selection Walk::finish() && {
  const Selection& found = selection_;
  std::string why;
  if (nearest_) {
    why = nearest_->entry.name + ", " + explain_miss(*nearest_->material, sets_.validation, scene_);
  }
  if (!found.choice) {
    selection_.reason = "no candidate meets the tolerance of " + number(scene_.tolerance) +
                        "; the nearest is " + why;
    return std::move(selection_);
  }
  const Choice& choice = *found.choice;
  std::string reason = found.entries[choice.entry].name + " has a certified error of " +
                       number(choice.error.value) + ", at most " + number(choice.error.upper) +
                       " with " + number(100 * choice.confidence, 6) +
                       " % confidence; the tolerance is " + number(scene_.tolerance);
  reason += nearest_ ? ". The best of what costs less, " + why : ". Nothing costs less";
  selection_.reason = reason;
  return std::move(selection_);
}

}  // namespace gonio::select
