#include "select/trials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/synthetic.h"
#include "select/candidates.h"

namespace gonio::testing {
namespace {

using Numbers = std::vector<double>;
using Random = std::mt19937_64;

double between(Random& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

Numbers colour(Random& random, double lower, double upper) {
  Numbers rgb;
  for (int c = 0; c < 3; ++c) rgb.push_back(between(random, lower, upper));
  return rgb;
}

LobeSpec base(Random& random) { return {"lambertian", {{"rd", colour(random, 0.1, 0.4)}}}; }

MaterialSpec over_base(Random& random, LobeSpec lobe) {
  return {{}, base(random), {std::move(lobe)}};
}

LobeSpec oren_nayar(Random& random, const char* form) {
  return {"oren_nayar",
          {{"rd", colour(random, 0.4, 0.9)},
           {"sigma", Numbers{between(random, 0.5, 0.9)}},
           {"form", form}}};
}

LobeSpec phong(Random& random, const char* model) {
  return {model,
          {{"s", Numbers{between(random, 10, 100)}},
           {"scale", colour(random, 0.2, 0.6)},
           {"fresnel", "none"}}};
}

LobeSpec ggx(Random& random, double least, double most) {
  const Numbers alpha{between(random, least, most)};
  return {"ggx",
          {{"alpha_x", alpha},
           {"alpha_y", alpha},
           {"scale", colour(random, 0.2, 0.6)},
           {"fresnel", "none"}}};
}

LobeSpec isotropic_ashikhmin_shirley(Random& random) {
  const Numbers exponent{between(random, 20, 200)};
  return {"ashikhmin_shirley",
          {{"nu", exponent},
           {"nv", exponent},
           {"rd", colour(random, 0.2, 0.6)},
           {"rs", colour(random, 0.1, 0.3)}}};
}

// u or v the rougher.
LobeSpec anisotropic(Random& random, const char* model, const char* u, const char* v, double least,
                     double most) {
  const double across = between(random, 0, 1) < 0.5 ? 0.3 : 3;
  const double middle = between(random, least, most);
  LobeSpec lobe{model, {{u, Numbers{middle}}, {v, Numbers{across * middle}}}};
  return lobe;
}

LobeSpec anisotropic_ggx(Random& random) {
  LobeSpec lobe = anisotropic(random, "ggx", "alpha_x", "alpha_y", 0.15, 0.3);
  lobe.parameters["scale"] = colour(random, 0.2, 0.6);
  lobe.parameters["fresnel"] = "none";
  return lobe;
}

LobeSpec anisotropic_ashikhmin_shirley(Random& random) {
  LobeSpec lobe = anisotropic(random, "ashikhmin_shirley", "nu", "nv", 30, 100);
  lobe.parameters["rd"] = colour(random, 0.2, 0.6);
  lobe.parameters["rs"] = colour(random, 0.1, 0.3);
  return lobe;
}

LobeSpec anisotropic_ward(Random& random) {
  return {"ward",
          {{"alpha_x", Numbers{between(random, 0.1, 0.2)}},
           {"alpha_y", Numbers{between(random, 0.3, 0.5)}},
           {"rs", colour(random, 0.2, 0.5)}}};
}

LobeSpec metal(Random& random) {
  const Numbers alpha{between(random, 0.2, 0.4)};
  return {"ggx",
          {{"alpha_x", alpha},
           {"alpha_y", alpha},
           {"f0", colour(random, 0.1, 0.4)},
           {"fresnel", "schlick"}}};
}

LobeSpec varnish(Random& random) {
  return {"cook_torrance",
          {{"m", Numbers{between(random, 0.15, 0.3)}},
           {"f0", Numbers{between(random, 0.04, 0.08)}},
           {"distribution", "beckmann"},
           {"fresnel", "schlick"}}};
}

Material material_of(const MaterialSpec& spec) { return *Material::create(spec); }

}  // namespace

const std::vector<Truth>& truths() {
  static const std::vector<Truth> kAll{
      {"lambertian",
       [](Random& r) {
         return MaterialSpec{base(r), {}, {}};
       }},
      {"oren_nayar:short",
       [](Random& r) {
         return MaterialSpec{oren_nayar(r, "short"), {}, {}};
       }},
      {"oren_nayar:full",
       [](Random& r) {
         return MaterialSpec{oren_nayar(r, "full"), {}, {}};
       }},
      {"phong:none",
       [](Random& r) {
         return MaterialSpec{phong(r, "phong"), {}, {}};
       }},
      {"lambertian + phong:none", [](Random& r) { return over_base(r, phong(r, "phong")); }},
      {"lambertian + blinn_phong:none",
       [](Random& r) { return over_base(r, phong(r, "blinn_phong")); }},
      {"ashikhmin_shirley",
       [](Random& r) {
         return MaterialSpec{isotropic_ashikhmin_shirley(r), {}, {}};
       }},
      {"ashikhmin_shirley, anisotropic",
       [](Random& r) {
         return MaterialSpec{anisotropic_ashikhmin_shirley(r), {}, {}};
       }},
      {"ggx:none, anisotropic",
       [](Random& r) {
         return MaterialSpec{anisotropic_ggx(r), {}, {}};
       }},
      {"lambertian + ward, anisotropic",
       [](Random& r) { return over_base(r, anisotropic_ward(r)); }},
      {"ggx:schlick",
       [](Random& r) {
         return MaterialSpec{metal(r), {}, {}};
       }},
      {"lambertian + ggx:none", [](Random& r) { return over_base(r, ggx(r, 0.15, 0.4)); }},
      {"lambertian + cook_torrance:beckmann:schlick",
       [](Random& r) { return over_base(r, varnish(r)); }},
      {"lambertian + 2 ggx:none", [](Random& r) {
         MaterialSpec spec = over_base(r, ggx(r, 0.4, 0.6));
         spec.specular.push_back(ggx(r, 0.06, 0.12));
         return spec;
       }}};
  return kAll;
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
    return fit::compare(material_of(result->choice->material), fresh, 0).errors.all.l1;
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
