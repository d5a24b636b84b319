#include "fit/report/metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "fit/data/unit.h"
#include "fit/linear/arrays.h"
#include "fit/report/worst_places.h"
#include "gonio/engine/evaluate.h"
#include "gonio/engine/isa.h"

namespace gonio::fit {
namespace {

constexpr std::size_t kRun = 4096;

Eigen::ArrayXd part(std::span<const float> all, std::size_t first, Eigen::Index count) {
  return Eigen::Map<const Eigen::ArrayXf>(&all[first], count).cast<double>();
}

// The root of a unit in which cube roots are taken: array_kernels.h has none of less than 1.6e-30.
double root_of_unit(const Data& data) {
  return std::exp2(std::round(std::log2(unit_of(data, true)) / 3));
}

// The terms of a run of pairs in one channel; `root`: that of the unit of cube roots.
struct Terms {
  Terms(const Eigen::ArrayXd& f, const Eigen::ArrayXd& m, double root)
      : measured(m),
        absolute((f - m).abs()),
        log((log_1p(f) - log_1p(m)).abs()),
        cbrt((cube_root(f * (1 / (root * root * root))) - cube_root(m * (1 / (root * root * root))))
                 .square()) {}
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
  [[nodiscard]] Errors errors(double root) const {
    if (pairs == 0) return {};
    const double unit = measured > 0 ? measured : weight;
    return {absolute / unit, std::sqrt(squared / weight), log / weight,
            root * std::sqrt(cbrt / weight), pairs};
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

std::array<double, 3> direction(const std::array<std::vector<float>, 3>& w, std::size_t i) {
  return {static_cast<double>(w[0][i]), static_cast<double>(w[1][i]), static_cast<double>(w[2][i])};
}

// What a material's values on the runs of the data come to.
class Tally {
 public:
  Tally(const Data& data, std::size_t worst)
      : data_(data), root_(root_of_unit(data)), places_(worst) {}

  // `values`: of the pairs from `first` on, channel by channel, kRun apart.
  void add_run(std::size_t first, std::size_t count, const std::vector<double>& values) {
    const auto n = static_cast<Eigen::Index>(count);
    const Run run(data_, first, n);
    above_.pairs += static_cast<std::size_t>(run.low.count());
    below_.pairs += count - static_cast<std::size_t>(run.low.count());
    for (int c = 0; c < data_.channels; ++c) {
      const std::size_t channel = values.size() == kRun ? 0 : static_cast<std::size_t>(c);
      add_channel(run, c, Eigen::Map<const Eigen::ArrayXd>(&values[channel * kRun], n));
    }
  }

  Comparison comparison() && {
    Sums all = below_;
    all.add(above_);
    for (Region* region : {&regions_.mirror, &regions_.toward_light, &regions_.elsewhere})
      divide(*region, all.measured > 0 ? all.measured : 1);
    return {{all.errors(root_), below_.errors(root_), above_.errors(root_)},
            regions_,
            std::move(places_).places(all.absolute)};
  }

 private:
  struct Run {
    Run(const Data& data, std::size_t from, Eigen::Index n)
        : first(from),
          cosine(part(data.wi[2], first, n)),
          w(part(data.weights, first, n)),
          low(cosine.min(part(data.wo[2], first, n)) < std::cos(kGrazing)),
          w_above(low.select(w, 0)),
          masks(data, first, n) {}
    std::size_t first;
    Eigen::ArrayXd cosine, w;
    Eigen::Array<bool, Eigen::Dynamic, 1> low;
    Eigen::ArrayXd w_above;
    RegionMasks masks;
  };

  void add_channel(const Run& run, int c, const Eigen::Map<const Eigen::ArrayXd>& f) {
    const Eigen::ArrayXd m = part(data_.channel(c), run.first, f.size());
    const Eigen::ArrayXd m_cosine = m * run.cosine;
    const Eigen::ArrayXd f_cosine = f * run.cosine;
    const Terms terms(f_cosine, m_cosine, root_);
    const RegionMasks& masks = run.masks;
    add(regions_.mirror, run.w * masks.mirror, f_cosine, terms);
    add(regions_.toward_light, run.w * masks.light, f_cosine, terms);
    add(regions_.elsewhere, run.w * (1 - masks.mirror - masks.light), f_cosine, terms);
    below_.add(run.w - run.w_above, terms);
    above_.add(run.w_above, terms);
    Eigen::Index at = 0;
    const double share = (run.w * terms.absolute).maxCoeff(&at);
    const std::size_t i = run.first + static_cast<std::size_t>(at);
    places_.offer({direction(data_.wi, i), direction(data_.wo, i), c, m[at], f[at], share});
  }

  const Data& data_;
  double root_;
  Sums below_, above_;
  Regions regions_;
  WorstPlaces places_;
};

}  // namespace

Comparison compare(const Material& material, const Data& data, std::size_t worst) {
  Tally tally(data, worst);
  std::vector<double> values(kRun * static_cast<std::size_t>(material.channels()));
  for (std::size_t first = 0; first < data.size(); first += kRun) {
    const std::size_t count = std::min(kRun, data.size() - first);
    evaluate(material,
             Batch<float, double>{data.incident(first), data.outgoing(first), count,
                                  Values<double>::planar(values.data(), kRun), nullptr},
             best_isa());
    tally.add_run(first, count, values);
  }
  return std::move(tally).comparison();
}

}  // namespace gonio::fit
