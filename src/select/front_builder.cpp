#include "select/front_builder.h"

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

FrontBuilder::FrontBuilder(const Scene& scene, const Sets& sets)
    : scene_(scene),
      sets_(sets),
      validation_(sets.validation),
      certification_(sets.certification) {}

void FrontBuilder::place_on_front(FittedCandidate& candidate) {
  Entry& entry = candidate.entry;
  if (!best_.empty()) {
    const Estimate difference = estimate_difference(candidate.errors, best_);
    const double degrees = static_cast<double>(best_.size()) - 1;
    const double upper =
        difference.value + difference.standard_error * student_quantile(kFrontConfidence, degrees);
    const auto value = [this](const std::vector<Ratio>& errors) {
      return root_if_square(estimate(errors).value, scene_.metric);
    };
    const double gain = value(best_) - value(candidate.errors);
    if (!(upper < 0 && gain > kShare * scene_.tolerance)) {
      entry.remark = "no better than " + best_name_;
      if (!entry.at_bounds.empty()) entry.remark += "; at a bound: " + joined(entry.at_bounds);
      return;
    }
  }
  entry.on_front = true;
  best_ = candidate.errors;
  best_name_ = entry.name;
}

// The material rounded to the fewest digits that do not increase its error on the second set.
Choice FrontBuilder::rounded_choice(const FittedCandidate& candidate, std::size_t index) const {
  Choice choice;
  choice.entry = index;
  choice.material = candidate.entry.material;
  if (candidate.entry.material) {
    const double most = candidate.entry.error.value + kShare * scene_.tolerance;
    for (int digits = kFewestDigits; digits <= kMostDigits; ++digits) {
      const MaterialSpec spec = rounded(*candidate.entry.material, digits);
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

void FrontBuilder::certify_error(FittedCandidate& candidate, std::size_t index) {
  Choice choice = rounded_choice(candidate, index);
  const Material material =
      choice.digits > 0 ? *Material::create(*choice.material) : *candidate.material;
  choice.confidence = 1 - (1 - scene_.confidence) * std::exp2(-static_cast<double>(++attempts_));
  choice.error =
      bounded(errors_of(material, certification_, scene_.metric), scene_.metric, choice.confidence);
  choice.pairs = sets_.certification.size();
  choice.float32_error = float32_error(material, certification_, scene_.metric);
  if (!(choice.error.upper < scene_.tolerance)) {
    candidate.entry.remark = "its certificate failed: at most " + number(choice.error.upper);
    return;
  }
  choice.needs_float64 = !(choice.error.upper + choice.float32_error < scene_.tolerance);
  selection_.choice = std::move(choice);
}

void FrontBuilder::add(FittedCandidate candidate) {
  const std::size_t index = selection_.entries.size();
  Entry& entry = candidate.entry;
  entry.error = bounded(candidate.errors, scene_.metric, kWorthTrying);
  entry.meets = entry.error.upper < scene_.tolerance;
  place_on_front(candidate);
  if (!has_choice()) {
    // An anisotropic candidate that errs less only by chance is not chosen.
    if (entry.meets && (entry.on_front || !candidate.anisotropic)) certify_error(candidate, index);
    if (!has_choice()) {
      if (entry.remark.empty()) entry.remark = "misses the tolerance";
      if (entry.on_front) nearest_ = candidate;
    }
  }
  selection_.entries.push_back(std::move(entry));
}

Selection FrontBuilder::finish() && {
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
