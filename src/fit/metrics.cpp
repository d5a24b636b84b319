#include "fit/metrics.h"

#include <algorithm>
#include <cmath>

#include "engine/evaluate.h"
#include "engine/isa.h"

namespace gonio::fit {
namespace {

constexpr std::size_t kRun = 4096;
// Two places closer than this in both directions are one: cos(5 degrees).
constexpr double kSamePlace = 0.9962;

struct Sums {
  double weight = 0, measured = 0, absolute = 0, squared = 0, log = 0, cbrt = 0;
  std::size_t pairs = 0;

  void add(double w, double f, double m) {
    const double e = f - m, root = std::cbrt(f) - std::cbrt(m);
    weight += w;
    measured += w * m;
    absolute += w * std::abs(e);
    squared += w * e * e;
    log += w * std::abs(std::log1p(f) - std::log1p(m));
    cbrt += w * root * root;
  }
  void add(const Sums& other) {
    weight += other.weight;
    measured += other.measured;
    absolute += other.absolute;
    squared += other.squared;
    log += other.log;
    cbrt += other.cbrt;
    pairs += other.pairs;
  }
  [[nodiscard]] Errors errors() const {
    if (pairs == 0) return {};
    const double unit = measured > 0 ? measured : weight;
    return {absolute / unit, std::sqrt(squared / weight), log / weight, std::sqrt(cbrt / weight),
            pairs};
  }
};

// The places with the largest contributions so far, none beside another.
class Worst {
 public:
  explicit Worst(std::size_t wanted) : wanted_(wanted) {}
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
  static double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static bool same(const Place& a, const Place& b) {
    return dot(a.wi, b.wi) > kSamePlace && dot(a.wo, b.wo) > kSamePlace;
  }
  std::size_t wanted_;
  std::vector<Place> places_;
};

std::array<double, 3> direction(const std::array<std::vector<float>, 3>& w, std::size_t i) {
  return {static_cast<double>(w[0][i]), static_cast<double>(w[1][i]), static_cast<double>(w[2][i])};
}

}  // namespace

Comparison compare(const Material& material, const Data& data, std::size_t worst) {
  const auto least = static_cast<float>(std::cos(kGrazing));
  Sums below, above;
  Worst places(worst);
  std::vector<double> values(kRun * static_cast<std::size_t>(material.channels()));
  for (std::size_t first = 0; first < data.size(); first += kRun) {
    const std::size_t count = std::min(kRun, data.size() - first);
    evaluate(material,
             Batch<float, double>{data.incident(first), data.outgoing(first), count,
                                  Values<double>::planar(values.data(), kRun), nullptr},
             best_isa());
    for (std::size_t i = first; i < first + count; ++i) {
      Sums& zone = std::min(data.wi[2][i], data.wo[2][i]) >= least ? below : above;
      const auto cosine = static_cast<double>(data.wi[2][i]), w = static_cast<double>(data.weights[i]);
      ++zone.pairs;
      for (int c = 0; c < data.channels; ++c) {
        const auto channel = static_cast<std::size_t>(material.channels() == 1 ? 0 : c);
        const double f = values[channel * kRun + i - first];
        const auto m = static_cast<double>(data.channel(c)[i]);
        zone.add(w, f * cosine, m * cosine);
        places.offer({direction(data.wi, i), direction(data.wo, i), c, m, f,
                      w * std::abs(f - m) * cosine});
      }
    }
  }
  Sums all = below;
  all.add(above);
  return {{all.errors(), below.errors(), above.errors()}, std::move(places).places(all.absolute)};
}

}  // namespace gonio::fit
