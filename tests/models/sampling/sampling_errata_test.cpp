// What Ashikhmin & Shirley's section 3 prints wrongly of sampling: the printed forms, which fail,
// beside the paper's own with the erratum mended and the library, which pass.
#include <algorithm>
#include <functional>
#include <numbers>

#include "models/oracle/densities.h"
#include "models/oracle/errata.h"
#include "models/oracle/formulas.h"
#include "models/sampling/sampling_cases.h"
#include "models/sampling/sampling_subject.h"

namespace gonio::testing {
namespace {

using std::numbers::pi;

MaterialSpec shirley(double nu, double nv, double rd) {
  return alone("ashikhmin_shirley",
               {{"nu", number(nu)}, {"nv", number(nv)}, {"rs", number(0.5)}, {"rd", number(rd)}});
}

SamplingSubject<double> library_of(const MaterialSpec& spec) {
  return library_sampling<double>(spec, sampler_of(spec), best_isa());
}

// The pdf: half of one strategy and half of the other, printed as "a weighted average of 1 and p".
constexpr double kExponent = 10, kIncidence = 60;

// p(k2) of equations 6 and 8.
double of_lobe(const Direction& wi, const double* wo) {
  const Vec<double> i{wi[0], wi[1], wi[2]}, h = normalized(sum(i, {wo[0], wo[1], wo[2]}));
  return anisotropic_phong(h, kExponent, kExponent) / dot(i, h);
}

// The mass above the horizon of a density, given cos(theta_o) and p(k2).
double mass(const std::function<double(double cos, double p)>& density) {
  const Direction wi = incidence(kIncidence, 0);
  return Subdivision(wi, 1,
                     [&](const std::vector<double>& wo) {
                       std::vector<double> column;
                       for (std::size_t i = 0; i < wo.size(); i += 3)
                         column.push_back(density(wo[i + 2], of_lobe(wi, &wo[i])));
                       return column;
                     })
      .integral(0);
}

double printed_density(double, double p) { return 0.5 * 1 + 0.5 * p; }
double mended_density(double cos, double p) { return 0.5 * cos / pi + 0.5 * p; }

double library_mass() {
  const MaterialSpec spec = shirley(kExponent, kExponent, 0.5);
  const auto library = library_of(spec);
  const Direction wi = incidence(kIncidence, 0);
  return Subdivision(wi, 1,
                     [&](const std::vector<double>& wo) { return library.evaluate(wi, wo).pdf; })
      .integral(0);
}

// The map from xi in [0, 1) to the azimuth of h, quadrant by quadrant.
constexpr double kNu = 10, kNv = 100;

// Equation 9, xi in a quadrant.
double azimuth(double xi) {
  return std::atan2(std::sqrt(kNu + 1) * std::sin(pi / 2 * xi),
                    std::sqrt(kNv + 1) * std::cos(pi / 2 * xi));
}
// In the odd quadrants the azimuth is mirrored; `in_mirrored` is what equation 9 is given there.
double over_quadrants(double xi, const std::function<double(double from_end)>& in_mirrored) {
  const double half = xi < 0.5 ? 0 : pi, within = xi < 0.5 ? xi : xi - 0.5;
  if (within < 0.25) return half + azimuth(4 * within);
  return half + pi - azimuth(in_mirrored(4 * (0.5 - within)));
}
double printed_azimuth(double xi) {
  return over_quadrants(xi, [](double from_end) { return 1 - from_end; });
}
double mended_azimuth(double xi) {
  return over_quadrants(xi, [](double from_end) { return from_end; });
}

// Light along the normal is reflected to the azimuth of h.
double library_azimuth(double xi) {
  static const SamplingSubject<double> library = library_of(shirley(kNu, kNv, 0));
  const std::vector<double> wo = library.draw({0, 0, 1}, {0, xi, 0.25}).wo;
  return std::atan2(wo[1], wo[0]);
}

double largest_jump(const std::function<double(double xi)>& map) {
  constexpr int kSteps = 2000;
  double most = 0, before = map(0);
  for (int i = 1; i < kSteps; ++i) {
    const double here = map(static_cast<double>(i) / kSteps);
    most = std::max(most, std::abs(std::remainder(here - before, 2 * pi)));
    before = here;
  }
  return most;
}

std::vector<Erratum> sampling_errata() {
  return {{"weighted average of 1 and p", mass(printed_density), library_mass(), 1, 1e-3, true,
           3.53, 5e-3},
          {"phi(1 - 4(0.5 - xi))", largest_jump(printed_azimuth), largest_jump(library_azimuth), 0,
           0.01, true, pi / 2, 0.01}};
}

TEST(SamplingErrata, PrintedFormFailsAndTheLibraryPasses) { expect_mended(sampling_errata()); }

// The paper's strategy loses what falls below the horizon; the library draws nothing there.
TEST(SamplingErrata, MendedFormPasses) {
  EXPECT_NEAR(mass(mended_density), 0.889, 5e-4);
  EXPECT_NEAR(library_mass(), 1, 1e-3);
  EXPECT_LT(largest_jump(mended_azimuth), 0.01);
}

// The printed map is not wrong as a density: its azimuths are as often in every place.
TEST(SamplingErrata, BothMapsHaveTheSameAzimuths) {
  constexpr int kSteps = 4000;
  std::vector<double> printed, mended;
  for (int i = 0; i < kSteps; ++i) {
    const double xi = (i + 0.5) / kSteps;
    printed.push_back(printed_azimuth(xi)), mended.push_back(mended_azimuth(xi));
  }
  std::ranges::sort(printed), std::ranges::sort(mended);
  for (std::size_t i = 0; i < kSteps; ++i) ASSERT_NEAR(printed[i], mended[i], 1e-9);
}

}  // namespace
}  // namespace gonio::testing
