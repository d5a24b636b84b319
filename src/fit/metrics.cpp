#include "fit/metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/evaluate.h"
#include "engine/isa.h"
#include "fit/arrays.h"

namespace gonio::fit {
namespace {

constexpr std::size_t kRun = 4096;
// Two places closer than this in both directions are one: cos(5 degrees).
constexpr double kSamePlace = 0.9962;

Eigen::ArrayXd part(std::span<const float> all, std::size_t first, Eigen::Index count) {
  return Eigen::Map<const Eigen::ArrayXf>(&all[first], count).cast<double>();
}

// The terms of a run of pairs in one channel.
struct Terms {
  Terms(const Eigen::ArrayXd& f, const Eigen::ArrayXd& m)
      : measured(m),
        absolute((f - m).abs()),
        log((log_1p(f) - log_1p(m)).abs()),
        cbrt((cube_root(f) - cube_root(m)).square()) {}
  const Eigen::ArrayXd& measured;
  Eigen::ArrayXd absolute, log, cbrt;
};

struct Sums {
  double weight = 0, measured = 0, absolute = 0, squared = 0, log = 0, cbrt = 0;
  std::size_t pairs = 0;

  // `w` is 0 outside the zone.
  void add(const Eigen::ArrayXd& w, const Terms& terms) {
    weight += w.sum();
    measured += (w * terms.measured).sum();
    absolute += (w * terms.absolute).sum();
    squared += (w * terms.absolute.square()).sum();
    log += (w * terms.log).sum();
    cbrt += (w * terms.cbrt).sum();
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

// Which region each pair of a run is in: 1 there, else 0.
struct RegionMasks {
  RegionMasks(const Data& data, std::size_t first, Eigen::Index n) {
    const double close = std::cos(25 * std::numbers::pi / 180);
    const auto at = [&](const std::vector<float>& all) { return part(all, first, n); };
    const Eigen::ArrayXd along = at(data.wi[2]) * at(data.wo[2]);
    const Eigen::ArrayXd across = at(data.wi[0]) * at(data.wo[0]) + at(data.wi[1]) * at(data.wo[1]);
    mirror = (along - across > close).cast<double>();
    light = (along + across > close).cast<double>() * (1 - mirror);
  }
  Eigen::ArrayXd mirror, light;
};

void add(Region& region, const Eigen::ArrayXd& w, const Eigen::ArrayXd& f, const Terms& terms) {
  region.measured += (w * terms.measured).sum();
  region.fitted += (w * f).sum();
  region.error += (w * terms.absolute).sum();
}

void divide(Region& region, double by) {
  region.measured /= by;
  region.fitted /= by;
  region.error /= by;
}

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
  Sums below, above;
  Regions regions;
  Worst places(worst);
  std::vector<double> values(kRun * static_cast<std::size_t>(material.channels()));
  for (std::size_t first = 0; first < data.size(); first += kRun) {
    const std::size_t count = std::min(kRun, data.size() - first);
    evaluate(material,
             Batch<float, double>{data.incident(first), data.outgoing(first), count,
                                  Values<double>::planar(values.data(), kRun), nullptr},
             best_isa());
    const auto n = static_cast<Eigen::Index>(count);
    const Eigen::ArrayXd cosine = part(data.wi[2], first, n), w = part(data.weights, first, n);
    const Eigen::Array<bool, Eigen::Dynamic, 1> low =
        cosine.min(part(data.wo[2], first, n)) < std::cos(kGrazing);
    const Eigen::ArrayXd w_above = low.select(w, 0), w_below = w - w_above;
    above.pairs += static_cast<std::size_t>(low.count());
    below.pairs += count - static_cast<std::size_t>(low.count());
    const RegionMasks masks(data, first, n);
    for (int c = 0; c < data.channels; ++c) {
      const auto channel = static_cast<std::size_t>(material.channels() == 1 ? 0 : c);
      const Eigen::Map<const Eigen::ArrayXd> f(&values[channel * kRun], n);
      const Eigen::ArrayXd m = part(data.channel(c), first, n);
      const Eigen::ArrayXd m_cosine = m * cosine;
      const Eigen::ArrayXd f_cosine = f * cosine;
      const Terms terms(f_cosine, m_cosine);
      add(regions.mirror, w * masks.mirror, f_cosine, terms);
      add(regions.toward_light, w * masks.light, f_cosine, terms);
      add(regions.elsewhere, w * (1 - masks.mirror - masks.light), f_cosine, terms);
      below.add(w_below, terms);
      above.add(w_above, terms);
      Eigen::Index at = 0;
      const double share = (w * terms.absolute).maxCoeff(&at);
      const std::size_t i = first + static_cast<std::size_t>(at);
      places.offer({direction(data.wi, i), direction(data.wo, i), c, m[at], f[at], share});
    }
  }
  Sums all = below;
  all.add(above);
  for (Region* region : {&regions.mirror, &regions.toward_light, &regions.elsewhere})
    divide(*region, all.measured > 0 ? all.measured : 1);
  return {{all.errors(), below.errors(), above.errors()},
          regions,
          std::move(places).places(all.absolute)};
}

}  // namespace gonio::fit
