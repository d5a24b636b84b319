// Where a material is far off. Internal to the metrics. Thread safety: used by one thread.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "fit/report/metrics.h"

namespace gonio::fit {

// The places with the largest contributions so far, none beside another.
class WorstPlaces {
 public:
  explicit WorstPlaces(std::size_t wanted) : wanted_(wanted) {}
  void offer(const Place& place) {
    if (wanted_ == 0 || (places_.size() == wanted_ && place.share <= places_.back().share)) return;
    const auto near = std::find_if(places_.begin(), places_.end(),
                                   [&](const Place& p) { return same(p, place); });
    if (near != places_.end()) {
      if (near->share >= place.share) return;
      places_.erase(near);
    }
    const auto at = std::find_if(places_.begin(), places_.end(),
                                 [&](const Place& p) { return p.share < place.share; });
    places_.insert(at, place);
    if (places_.size() > wanted_) places_.pop_back();
  }
  std::vector<Place> places(double total) && {
    for (Place& place : places_) place.share /= total > 0 ? total : 1;
    return std::move(places_);
  }

 private:
  // Two places closer than this in both directions are one: cos(5 degrees).
  static constexpr double kSamePlace = 0.9962;

  static double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static bool same(const Place& a, const Place& b) {
    return dot(a.wi, b.wi) > kSamePlace && dot(a.wo, b.wo) > kSamePlace;
  }
  std::size_t wanted_;
  std::vector<Place> places_;
};

}  // namespace gonio::fit
