#include "select/reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "gonio/engine/sampler.h"

namespace gonio::select {
namespace {

constexpr std::size_t kFewestPairs = 200;
constexpr std::size_t kAsked =
    1024;  // pairs between two calls of `stop`: a density goes through all bins

Error stopped() { return {ErrorCode::cancelled, "the selection was stopped", {}, {}, {}}; }

Direction direction(const std::array<std::vector<float>, 3>& w, std::size_t i) {
  return {static_cast<double>(w[0][i]), static_cast<double>(w[1][i]), static_cast<double>(w[2][i])};
}

Error too_few(std::size_t found, const fit::Data& data) {
  const fit::LeftOut& out = data.left_out;
  const std::size_t all = data.size() + out.total();
  return bad_value(
      "reference",
      std::to_string(found) + " usable pairs of " + std::to_string(all) + " (" +
          std::to_string(out.not_finite) + " not finite, " + std::to_string(out.negative) +
          " negative, " + std::to_string(out.total() - out.not_finite - out.negative) +
          " for other reasons, " + std::to_string(data.size() - found) + " outside the scene)",
      "at least " + std::to_string(kFewestPairs) + " within the scene's angles");
}

// Relative errors are undefined where nothing is reflected.
Outcome check_light(const fit::Data& data) {
  const bool dark =
      std::all_of(data.values.begin(), data.values.end(), [](float value) { return !(value > 0); });
  if (!dark) return Ok{};
  return bad_value("reference", "0 everywhere in the scene", "values of which some are above 0");
}

// Whether all wi lie in one plane with the normal.
bool of_one_azimuth(const fit::Data& data) {
  constexpr float kNone = 1e-4F;
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < data.size(); ++i) {
    if (data.wi[2][i] < data.wi[2][lowest]) lowest = i;
  }
  const float x = data.wi[0][lowest], y = data.wi[1][lowest];
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (std::abs(data.wi[0][i] * y - data.wi[1][i] * x) > kNone) return false;
  }
  return true;
}

// Turns each pair about the normal by a random angle.
void turn(fit::Data& data, std::mt19937_64& random) {
  std::uniform_real_distribution<float> turned(0, 2 * std::numbers::pi_v<float>);
  for (std::size_t i = 0; i < data.size(); ++i) {
    const float by = turned(random), c = std::cos(by), s = std::sin(by);
    for (auto* w : {&data.wi, &data.wo}) {
      const float x = (*w)[0][i], y = (*w)[1][i];
      (*w)[0][i] = c * x - s * y, (*w)[1][i] = s * x + c * y;
    }
  }
}

Sets cut(const fit::Data& data, std::span<const std::size_t> order, const SetSizes& sizes) {
  const std::size_t all = std::min(order.size(), sizes.total());
  const std::size_t fitted = std::min(sizes.fitted, all / 3), judged = all - fitted;
  const std::size_t validation =
      judged * sizes.validation / (sizes.validation + sizes.certification);
  return {fit::pick(data, order.subspan(0, fitted), 1),
          fit::pick(data, order.subspan(fitted, validation), 1),
          fit::pick(data, order.subspan(fitted + validation, all - fitted - validation), 1)};
}

// Replaces half of the wo by draws of the sampler. Densities are with respect to wo, wi being
// given.
struct Draws {
  std::vector<double> wi, wo, values, weights;
};

std::vector<float> narrow(const std::vector<double>& x) { return {x.begin(), x.end()}; }

void redraw_half(const Sampler& sampler, std::size_t count, std::uint64_t seed, Draws& draws) {
  const std::size_t half = count / 2;
  const std::vector<float> wi = narrow(draws.wi);
  std::vector<float> wo(3 * half), pdf(half);
  SampleBatch<float> batch;
  batch.wi = Directions<float>::interleaved(wi.data());
  batch.count = half;
  batch.numbers = {Sequence::random, seed};
  batch.wo = wo.data();
  batch.pdf = pdf.data();
  sample(sampler, batch, best_isa());
  std::copy(wo.begin(), wo.end(), draws.wo.begin());
}

void evaluate_draws(const Sampler& sampler, const Distribution& scene, std::size_t count,
                    const Stop& stop, Draws& draws) {
  const int channels = sampler.material().channels();
  const std::vector<float> wi = narrow(draws.wi), wo = narrow(draws.wo);
  draws.values.resize(count * static_cast<std::size_t>(channels));
  std::vector<double> pdf(count);
  std::vector<std::uint8_t> flags(count);
  evaluate(sampler,
           Batch<float, double>{
               Directions<float>::interleaved(wi.data()), Directions<float>::interleaved(wo.data()),
               count, Values<double>::interleaved(draws.values.data(), channels), flags.data()},
           pdf.data(), best_isa());
  draws.weights.assign(count, 0);
  for (std::size_t i = 0; i < count && !(i % kAsked == 0 && stop && stop()); ++i) {
    if (flags[i] != 0) continue;  // below the horizon, or a hole in a table: the value is not known
    const Direction in{draws.wi[3 * i], draws.wi[3 * i + 1], draws.wi[3 * i + 2]};
    const Direction out{draws.wo[3 * i], draws.wo[3 * i + 1], draws.wo[3 * i + 2]};
    const double of_scene = scene.density(in, out) / scene.incident_density(in);
    if (of_scene > 0) draws.weights[i] = of_scene / (0.5 * of_scene + 0.5 * pdf[i]);
  }
}

}  // namespace

Result<Sets> sets_of(const fit::Data& data, const Distribution& scene, const SetSizes& sizes,
                     std::uint64_t seed, const Stop& stop) {
  std::vector<std::size_t> inside;
  std::vector<float> weights(data.size(), 0);
  double sum = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (i % kAsked == 0 && stop && stop()) return stopped();
    const double density = scene.density(direction(data.wi, i), direction(data.wo, i));
    if (!(density > 0)) continue;
    inside.push_back(i);
    weights[i] = static_cast<float>(static_cast<double>(data.weights[i]) * density);
    sum += static_cast<double>(weights[i]);
  }
  if (inside.size() < kFewestPairs || !(sum > 0)) return too_few(inside.size(), data);
  std::mt19937_64 random(seed);
  std::shuffle(inside.begin(), inside.end(), random);
  inside.resize(std::min(inside.size(), sizes.total()));
  fit::Data kept = fit::pick(data, inside, 1);
  for (std::size_t i = 0; i < inside.size(); ++i) kept.weights[i] = weights[inside[i]];
  if (auto light = check_light(kept); !light) return light.error();
  if (of_one_azimuth(kept)) turn(kept, random);
  std::vector<std::size_t> order(inside.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return cut(kept, order, sizes);
}

fit::Data draw_pairs(const Material& reference, const Distribution& scene, std::size_t count,
                     std::uint64_t seed, const Stop& stop) {
  std::mt19937_64 random(seed);
  const Sampler sampler = Sampler::create(reference);
  Draws draws;
  for (std::size_t i = 0; i < count; ++i) {
    const Pair pair = scene.draw(random);
    draws.wi.insert(draws.wi.end(), pair.wi.begin(), pair.wi.end());
    draws.wo.insert(draws.wo.end(), pair.wo.begin(), pair.wo.end());
  }
  redraw_half(sampler, count, seed, draws);
  evaluate_draws(sampler, scene, count, stop, draws);
  // Samples outside the scene, or lost, have weight 0 and are left out. The mean still counts them:
  // which ones are left out is random, and the same for all candidates.
  fit::Data data =
      *fit::from_pairs(draws.wi, draws.wo, draws.values, reference.channels(), draws.weights);
  data.left_out.no_weight = 0;
  data.left_out.below_horizon = 0;
  // The sampler's draws come first.
  std::vector<std::size_t> order(data.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  return fit::pick(data, order, 1);
}

Result<Sets> sets_of(const Material& reference, const Distribution& scene, const SetSizes& sizes,
                     std::uint64_t seed, const Stop& stop) {
  const fit::Data data = draw_pairs(reference, scene, sizes.total(), seed, stop);
  if (stop && stop()) return stopped();
  if (data.size() < kFewestPairs) return too_few(data.size(), data);
  if (auto light = check_light(data); !light) return light.error();
  std::vector<std::size_t> order(data.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return cut(data, order, sizes);
}

}  // namespace gonio::select
