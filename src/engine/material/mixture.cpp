// The shares that give a mixture's weights the least variance, one angle of incidence at a time.
//
// With g = f cos(theta_o), the mean over the channels, and the strategies' densities q_k, the
// second moment of g / sum(p_k q_k) is a convex function of the shares p_k. Its integral is a sum
// over directions that all strategies have drawn, as many each; p_k *= integral of q_k (g / sum(p
// q))^2 over that of p_k q_k (g / sum(p q))^2 summed over k goes down at every step and keeps the
// sum 1.
//
// In float64 by the baseline's kernels, so that every machine has the same shares.
#include "engine/material/mixture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/material/flush_to_zero.h"
#include "engine/sampling/strategies.h"
#include "gonio/engine/random_numbers.h"

namespace gonio {
namespace {

constexpr int kNodes = MixtureTable::kNodes;
constexpr int kMaxStrategies = MixtureTable::kMaxLobes + 1;
constexpr std::size_t kDrawn = 128;   // directions of each strategy
constexpr double kLeastShare = 0.02;  // so that no noise of this sum starves a lobe
constexpr double kNothing = 1e-30;    // what g may be where lobes' densities have become 0
// Without the cosine a sample costs less; worth so much more of the variance.
constexpr double kWorth = 1.05;

using Shares = std::array<double, kMaxStrategies>;

// At one angle of incidence: g and the densities at all directions drawn.
class Quadrature {
 public:
  Quadrature(const Material::Impl& material, const Sampler::Impl& sampler, double cos_i,
             double azimuth)
      : material_(material), sampler_(sampler), count_(kDrawn * strategies()) {
    const double sine = std::sqrt(1 - cos_i * cos_i);
    const double wi[3] = {sine * std::cos(azimuth), sine * std::sin(azimuth), cos_i};
    for (int c = 0; c < 3; ++c) {
      wi_[c].assign(count_, wi[c]);
      wo_[c].assign(count_, 0);
    }
    draw();
    evaluate();
  }

  [[nodiscard]] std::size_t strategies() const {
    return static_cast<std::size_t>(sampler_.lobes) + 1;
  }

  // The second moment of the weight, and its derivatives by the shares (but for their sign).
  double second_moment(const Shares& shares, Shares& falls) const {
    falls.fill(0);
    double moment = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      double mixture = 0, drawn = 0;
      for (std::size_t k = 0; k < strategies(); ++k) {
        mixture += shares[k] * density_[k][i];
        drawn += density_[k][i];
      }
      if (!(g_[i] > kNothing)) continue;
      // What no strategy draws, no weight can make up for.
      if (!(mixture > 0)) return std::numeric_limits<double>::infinity();
      const double ratio = g_[i] / mixture;
      const double part = ratio * ratio / (drawn * static_cast<double>(kDrawn));
      moment += part * mixture;
      for (std::size_t k = 0; k < strategies(); ++k) falls[k] += part * density_[k][i];
    }
    return moment;
  }

  [[nodiscard]] double albedo() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      double drawn = 0;
      for (std::size_t k = 0; k < strategies(); ++k) drawn += density_[k][i];
      if (drawn > 0) sum += g_[i] / (drawn * static_cast<double>(kDrawn));
    }
    return sum;
  }

 private:
  using Column = std::vector<double>;

  void draw() {
    const SamplingTable& table = sampling_kernels(Isa::baseline);
    Column xi[3];
    for (Column& x : xi) x.resize(kDrawn);
    random_numbers({Sequence::sobol, 1}, 0, kDrawn, kDrawn,
                   {xi[0].data(), xi[1].data(), xi[2].data()});
    std::size_t k = 0;
    const auto run = [&] {
      const std::size_t at = k++ * kDrawn;
      return DrawRun<double>{{&wi_[0][at], &wi_[1][at], &wi_[2][at]},
                             {xi[0].data(), xi[1].data(), xi[2].data()},
                             nullptr,
                             0,
                             kDrawn,
                             {&wo_[0][at], &wo_[1][at], &wo_[2][at]}};
    };
    for (std::size_t i = 0; i < material_.parts.size(); ++i) {
      const Strategy part = strategy(material_, sampler_, i);
      if (part.draws()) part.draw(Isa::baseline, run());
    }
    table.cosine64(nullptr, run());
  }

  void evaluate() {
    const auto channels = static_cast<std::size_t>(material_.channels);
    Column values(count_ * channels);
    std::vector<std::uint8_t> flags(count_);
    const KernelInput<double> in{{wi_[0].data(), wi_[1].data(), wi_[2].data()},
                                 {wo_[0].data(), wo_[1].data(), wo_[2].data()},
                                 count_};
    KernelOutput<double> out{values.data(), count_, flags.data(), false};
    std::size_t lobe = 0;
    for (std::size_t i = 0; i < material_.parts.size(); ++i) {
      const Strategy part = strategy(material_, sampler_, i);
      DensityOutput<double> density{nullptr, nullptr, false};
      if (part.draws()) {
        density_[lobe].resize(count_);
        density.pdf = density_[lobe++].data();
      }
      part.evaluate(Isa::baseline, in, out, density);
      out.accumulate = true;
    }
    Column& cosine = density_[strategies() - 1];
    cosine.resize(count_);
    g_.assign(count_, 0);
    for (std::size_t i = 0; i < count_; ++i) {
      const double cos_o = std::max(wo_[2][i], 0.0);
      cosine[i] = cos_o * std::numbers::inv_pi;
      for (std::size_t c = 0; c < channels; ++c) g_[i] += values[c * count_ + i];
      g_[i] *= cos_o / static_cast<double>(channels);
    }
  }

  const Material::Impl& material_;
  const Sampler::Impl& sampler_;
  std::size_t count_;
  Column wi_[3], wo_[3], g_;
  std::array<Column, kMaxStrategies> density_;
};

// The best shares, or the best without the last strategy, and the second moment they give.
double best_shares(const Quadrature& at, bool with_cosine, Shares& shares) {
  const std::size_t used = at.strategies() - (with_cosine ? 0 : 1);
  shares.fill(0);
  std::fill_n(shares.begin(), used, 1.0 / static_cast<double>(used));
  Shares falls;
  for (int step = 0; step < 50; ++step) {
    const double moment = at.second_moment(shares, falls);
    if (!(moment > 0 && std::isfinite(moment))) break;
    for (std::size_t k = 0; k < used; ++k) shares[k] *= falls[k] / moment;
  }
  double sum = 0;
  for (std::size_t k = 0; k < used; ++k) sum += shares[k] = std::max(shares[k], kLeastShare);
  for (std::size_t k = 0; k < used; ++k) shares[k] /= sum;
  return at.second_moment(shares, falls);
}

}  // namespace

void tabulate_shares(const Material::Impl& material, Sampler::Impl& sampler) {
  const FlushToZero flush;
  std::array<Shares, kNodes> with{}, without{};
  const double azimuth = std::numbers::pi / 4 + material.rotation * (std::numbers::pi / 180);
  // A table that knows nothing somewhere needs it.
  bool cosine = sampler.has_gaps;
  for (int i = 0; i < kNodes; ++i) {
    // The first node stands for what is next to grazing.
    const double root = std::max(i, 1) / (kNodes - 1.0) - (i == 0 ? 0.5 / (kNodes - 1.0) : 0);
    const Quadrature at(material, sampler, root * root, azimuth);
    const auto node = static_cast<std::size_t>(i);
    const double moment = best_shares(at, true, with[node]);
    const double moment_without = best_shares(at, false, without[node]);
    const double square = at.albedo() * at.albedo();
    cosine |= moment_without - square > kWorth * (moment - square) + 1e-3 * square;
  }
  sampler.cosine = cosine;
  sampler.table.given = sampler.strategies() - 1;
  for (int k = 0; k < sampler.table.given; ++k) {
    for (int i = 0; i < kNodes; ++i) {
      const auto node = static_cast<std::size_t>(i);
      sampler.table.values[k * kNodes + i] =
          static_cast<float>((cosine ? with : without)[node][static_cast<std::size_t>(k)]);
    }
  }
}

}  // namespace gonio
