// Grazing angles: errors by zone of fits of each zone, and which of Phong's and Blinn's lobes the
// measured ones are like there. The mixture's share says where between: 0 is Phong's, which is
// round about the mirror direction, 1 Blinn's, which grows long in the plane of incidence.
#include <cstdio>
#include <numbers>
#include <string>

#include "data_folder.h"
#include "fit_modes.h"
#include "measured/pairs.h"
#include "measured/solid_angle.h"

namespace gonio::bench {
namespace {

struct Zone {
  const char* name;
  double min_theta, max_theta;
};
constexpr double kDegree = std::numbers::pi / 180;
constexpr std::array kZones{Zone{"<= 80", 0, fit::kGrazing},
                            Zone{"> 80", fit::kGrazing, 90 * kDegree},
                            Zone{"both", 0, 90 * kDegree}};

fit::FitResult fitted(const fit::Data& data, const char* model, const Zone& zone) {
  fit::Options options;
  options.min_theta = zone.min_theta;
  options.max_theta = zone.max_theta;
  return *fit::fit(data, testing::over_lambertian(model, "dielectric"), options);
}

void print_by_zone(const char* material, const fit::Data& data) {
  for (const char* model : kModels) {
    std::printf("%-20s %-14s", material, model);
    for (const Zone& zone : kZones) {
      const fit::ErrorsByZone errors = fitted(data, model, zone).certificate.errors;
      std::printf("  %.4f %.4f", errors.below_80.l1, errors.above_80.l1);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

// The error of each lobe where it was fitted, and the mixture's share with the range of it that
// comes within 1 % of the best.
void print_lobe(const std::string& name, const fit::Data& data, const Zone& zone) {
  const fit::Data there = fit::within(data, zone.min_theta, zone.max_theta);
  const fit::FitResult phong = fitted(there, "phong", zone), mix = fitted(there, "phong_mix", zone);
  const fit::FitResult blinn = fitted(there, "blinn_phong", zone);
  const double round = phong.certificate.errors.all.l1, half = blinn.certificate.errors.all.l1;
  std::printf("%-22s %-8s %6zu  %.4f %.4f %.4f ", name.c_str(), zone.name, there.size(), round,
              half, mix.certificate.errors.all.l1);
  for (const fit::Profile& p : mix.certificate.profiles) {
    if (p.field.find(".mix") == std::string::npos) continue;
    const auto& share = mix.material.specular[0].parameters.at("mix");
    std::printf(" %.2f [%.2f, %.2f]", std::get<std::vector<double>>(share)[0], p.lower, p.upper);
  }
  const char* which = round < 0.98 * half ? "Phong" : half < 0.98 * round ? "Blinn" : "neither";
  const bool failed = mix.certificate.verdict == fit::Verdict::failed;
  std::printf("  %s%s\n", which, failed ? (" (" + mix.certificate.reason + ")").c_str() : "");
  std::fflush(stdout);
}

fit::Data weighed(const Result<MeasuredPairs>& pairs) {
  const auto weights =
      pairs->weights.empty() ? pair_measures(pairs->wi, pairs->wo) : pairs->weights;
  return *fit::from_pairs(pairs->wi, pairs->wo, pairs->values, pairs->channels, weights);
}

}  // namespace

bool print_grazing() {
  std::printf("L1 at theta <= 80 and > 80 degrees, of fits of <= 80, > 80, both\n");
  for (const char* material : testing::kFitMaterials) print_by_zone(material, load(material));
  std::printf(
      "\nWhich lobe: L1 in the zone that was fitted of phong, blinn_phong and phong_mix;\n");
  std::printf("mix and its range within 1 %% of the best; which of the two is better by 2 %%\n");
  for (const char* material : testing::kFitMaterials) {
    const fit::Data data = load(material);
    for (const Zone& zone : {kZones[0], Zone{"60 - 80", 60 * kDegree, fit::kGrazing}, kZones[1]})
      print_lobe(material, data, zone);
  }
  // Goniometers end at 80 degrees: the steep part and what comes closest to the horizon.
  const std::array zones{Zone{"<= 60", 0, 60.5 * kDegree},
                         Zone{"60 - 90", 60.5 * kDegree, 90 * kDegree}};
  for (const char* paint : {"garnet_red", "krylon_blue", "mystique"}) {
    const auto file = testing::data_folder() / "cornell" / (std::string(paint) + ".brdf");
    const fit::Data data = weighed(read_cornell(file));
    for (const Zone& zone : zones) print_lobe(std::string("cornell/") + paint, data, zone);
  }
  for (const char* tape : {"retro-3M-jaune", "retro-gray-tape"}) {
    const auto file = testing::data_folder() / "retro" / (std::string(tape) + ".dat");
    const fit::Data data = weighed(read_alta(file));
    for (const Zone& zone : zones) print_lobe(tape, data, zone);
  }
  // The last angle of incidence below 90 degrees is 79 or 80.
  const std::array wider{Zone{"<= 60", 0, 60.5 * kDegree},
                         Zone{"60 - 80", 60.5 * kDegree, 80.5 * kDegree},
                         Zone{"> 80", 80.5 * kDegree, 90 * kDegree}};
  for (const char* material :
       {"paper_white", "satin_rosaline", "cc_ibiza_sunset", "cg_sunflower"}) {
    const auto file = testing::data_folder() / "rgl" / (std::string(material) + "_rgb.bsdf");
    const fit::Data data = weighed(read_rgl(file));
    for (const Zone& zone : wider) print_lobe(std::string("rgl/") + material, data, zone);
  }
  return true;
}

}  // namespace gonio::bench
