#include "select/trials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/synthetic.h"
#include "select/candidates.h"

namespace gonio::testing {
namespace {

Material material_of(const MaterialSpec& spec) { return *Material::create(spec); }

}  // namespace

double between(Random& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

select::Scene scene_to(double degrees, double tolerance) {
  const select::Range range{0, degrees * std::numbers::pi / 180};
  select::Scene scene;
  scene.bins = {{range, range}};
  scene.tolerance = tolerance;
  return scene;
}

select::CostTable fixed_costs() {
  const std::vector<std::pair<std::string_view, double>> models{{"lambertian", 1.0},
                                                                {"oren_nayar:short", 3.4},
                                                                {"oren_nayar:full", 9.2},
                                                                {"ward", 3.3},
                                                                {"blinn_phong", 3.8},
                                                                {"ggx", 4.1},
                                                                {"cook_torrance:beck", 4.0},
                                                                {"cook_torrance:cos", 5.0},
                                                                {"ashikhmin_shirley", 4.6},
                                                                {"phong_mix", 7.6},
                                                                {"phong", 4.9}};
  const std::vector<std::pair<std::string_view, double>> fresnels{
      {":schlick", 0.3}, {":dielectric", 0.9}, {":conductor", 1.6}};
  select::CostTable costs;
  for (const select::Candidate& candidate : select::candidates(scene_to(75, 1), 3, 2)) {
    for (const std::string& part : candidate.parts) {
      const auto model = std::find_if(models.begin(), models.end(), [&](const auto& known) {
        return part.starts_with(known.first);
      });
      if (model == models.end()) continue;  // a new model: choose() says that the table lacks it
      costs[part] = model->second;
      for (const auto& [word, more] : fresnels) {
        if (part.ends_with(word)) costs[part] += more;
      }
    }
  }
  return costs;
}

select::Options trial_options(std::uint64_t seed) {
  select::Options options;
  options.whole_front = false;
  options.costs = fixed_costs();
  options.sizes = {2000, 1500, 2000};
  options.seed = seed;
  return options;
}

Trial run_trial(const Truth& truth, std::uint64_t seed) {
  Random random(seed);
  const MaterialSpec spec = truth.draw(random);
  const auto at = static_cast<unsigned>(seed);
  const fit::Data data = data_of(spec, scattered_pairs(6000, at), 0.02, at + 1);
  const auto result = select::choose(data, scene_to(75, 0.02), trial_options(seed));
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().message);
  Trial trial{*result, "nothing", false};
  if (!trial.selection.choice) return trial;
  const select::Entry& chosen = trial.selection.entries[trial.selection.choice->entry];
  trial.chosen = chosen.name;
  for (const select::Candidate& candidate : select::candidates(scene_to(75, 1), 3, 2))
    if (candidate.name == truth.name) trial.larger = chosen.parameters > candidate.parameters;
  return trial;
}

Check run_check(const Truth& truth, std::uint64_t seed) {
  constexpr std::size_t kFresh = 100'000;
  Random random(seed);
  const Material reference = material_of(truth.draw(random));
  select::Scene scene = scene_to(75, 0.02 * std::pow(20, between(random, 0, 1)));
  const select::Distribution distribution(scene);
  const fit::Data fresh = select::draw_pairs(reference, distribution, kFresh, seed + 1);
  const auto error_of_choice = [&](std::uint64_t by) -> std::optional<double> {
    select::Options options = trial_options(by);
    options.sizes = {1000, 1000, 1000};
    const auto result = select::choose(reference, scene, options);
    if (!result || !result->choice) return std::nullopt;
    return fit::compare(material_of(*result->choice->material), fresh, 0).errors.all.l1;
  };
  const auto first = error_of_choice(seed);
  if (!first) return {};
  scene.tolerance = *first * between(random, 0.97, 1.1);
  const auto second = error_of_choice(seed + 2);
  return {second.has_value(), second && *second > scene.tolerance};
}

Coverage run_coverage(const Truth& truth, std::uint64_t seed, std::size_t draws,
                      std::size_t pairs) {
  constexpr std::size_t kAll = 400'000;
  Random random(seed);
  const Material reference = material_of(truth.draw(random)),
                 other = material_of(truth.draw(random));
  const select::Distribution scene(scene_to(75, 1));
  const auto error_on = [&](std::size_t count, std::uint64_t by) {
    const auto data = select::draw_pairs(reference, scene, count, by);
    return bounded(errors_of(other, select::Blocks(data), select::Metric::l1), select::Metric::l1,
                   0.95);
  };
  const double truly = error_on(kAll, seed).value;
  Coverage coverage;
  for (; coverage.draws < draws; ++coverage.draws)
    coverage.misses += error_on(pairs, seed + 1 + coverage.draws).upper < truly ? 1 : 0;
  return coverage;
}

}  // namespace gonio::testing
