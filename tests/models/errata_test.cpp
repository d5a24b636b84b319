// What the source documents print wrongly, and what is right: for each erratum a number that the
// printed form gets wrong and that the library gets right.
//
// The printed forms stand here and nowhere else.
#include "models/oracle/errata.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace gonio::testing {
namespace {

using Vector = Vec<double>;
constexpr double kPi = std::numbers::pi;
const Vector kNormal{0, 0, 1};

// The library's f in float64.
double f(const MaterialSpec& spec, const Vector& wi, const Vector& wo) {
  const std::vector<DirectionPair<double>> pair{
      {{wi.x, wi.y, wi.z}, {wo.x, wo.y, wo.z}, PairKind::special}};
  return library_values<double>(material_of(spec), pair, best_isa())[0];
}

MaterialSpec lobe(Parameters parameters) {
  parameters["m"] = number(0.5);
  return alone("cook_torrance", std::move(parameters));
}

// The library's Fresnel factor, which is what a lobe with it has over one without.
double library_fresnel(const Parameters& parameters, const Vector& wi, const Vector& wo) {
  return f(lobe(parameters), wi, wo) / f(lobe({}), wi, wo);
}

const Parameters kGlass{{"eta", number(1.5)}};

// Cook and Torrance's form with the signs of the two printed ones.
double fresnel_with(double c, double g_sign, double denominator_sign) {
  const double g = std::sqrt(2.25 + c * c + g_sign);
  const double a = (g - c) / (g + c);
  const double b = (c * (g + c) - 1) / (c * (g - c) + denominator_sign);
  return a * a * (1 + b * b) / 2;
}

double largest(const std::function<double(double degrees)>& g) {
  double most = 0;
  for (double degrees = 0; degrees < 90; degrees += 0.25) most = std::max(most, g(degrees));
  return most;
}

// The integral of D cos over the hemisphere, for functions of the polar angle only: the area of a
// distribution, or the albedo of a lobe at normal incidence.
double projected_area(const std::function<double(const Vector&)>& d) {
  double sum = 0;
  constexpr int kSteps = 4000;
  for (int i = 0; i < kSteps; ++i) {
    const double theta = (i + 0.5) * 90 / kSteps;
    const Vector h = at(theta);
    sum += d(h) * h.z * std::sin(theta * kDegree) * (kPi / 2 / kSteps) * 2 * kPi;
  }
  return sum;
}

// The library's D, from f = D G / (4 cos^2) where all directions are one and G = min(1, 2 cos^2).
double library_d(const Vector& h) {
  const double cos2 = h.z * h.z;
  return f(lobe({}), h, h) * 4 * cos2 / std::min(1.0, 2 * cos2);
}

double beckmann_over_4(const Vector& h) { return beckmann(h, 0.5) * kPi / 4; }

struct HalfVector {
  Vector h;
  double hk;
};
HalfVector half_vector(const Vector& wi, const Vector& wo) {
  const Vector h = normalized(sum(wi, wo));
  return {h, dot(h, wi)};
}

double printed_cook_torrance(const Vector& wi, const Vector& wo) {
  const auto [h, hk] = half_vector(wi, wo);
  return beckmann(h, 0.5) * v_groove(wi.z, wo.z, h.z, hk) / wo.z;
}

// "G = (1, Gm, Gs)": a list, of which C takes the last.
double printed_g(const Vector& wi, const Vector& wo) {
  const auto [h, hk] = half_vector(wi, wo);
  return 2 * h.z * wi.z / hk;
}

double library_g(const Vector& wi, const Vector& wo) {
  const Vector h = half_vector(wi, wo).h;
  return f(lobe({}), wi, wo) * 4 * wi.z * wo.z / library_d(h);
}

// n.h at wi = wo = n, from the lobe (n.h)^8 that the library gives there.
double library_n_h() {
  const MaterialSpec spec =
      alone("ashikhmin_shirley",
            {{"nu", number(8)}, {"nv", number(8)}, {"rs", number(1)}, {"rd", number(0)}});
  return std::pow(f(spec, kNormal, kNormal) * 8 * kPi / 9, 1 / 8.0);
}

std::vector<Erratum> fresnel_errata() {
  const double normal = library_fresnel(kGlass, kNormal, kNormal);
  const auto library_at = [](double degrees) {
    return library_fresnel(kGlass, at(degrees), at(degrees, 180));
  };
  const Vector slanted = at(75);
  const double half_cos = std::cos(37.5 * kDegree);
  return {
      {"g^2 = eta^2 + c^2 + 1", fresnel_with(1, +1, +1), normal, 0.04, 1e-9, false, 0.120},
      {"denominator c(g - c) - 1", fresnel_with(1, -1, -1), normal, 0.04, 1e-9, false, 0.200},
      {"both signs: a pole",
       largest([](double d) { return fresnel_with(std::cos(d * kDegree), +1, -1); }),
       largest(library_at), 1, 1e-9, true},
      {"c = n.s, dielectric", fresnel_with(slanted.z, -1, +1),
       library_fresnel(kGlass, slanted, kNormal), fresnel_with(half_cos, -1, +1), 1e-9, false,
       0.253},
      {"c = n.s, Schlick", schlick(slanted.z, 0.04),
       library_fresnel({{"f0", number(0.04)}}, slanted, kNormal), schlick(half_cos, 0.04), 1e-9}};
}

std::vector<Erratum> lobe_errata() {
  const auto exchanged = [](const auto& g) { return g(at(20), at(70)) / g(at(70), at(20)); };
  const auto library_f = [](const Vector& wi, const Vector& wo) { return f(lobe({}), wi, wo); };
  // G for light and viewer on the same side, where the unclamped term is largest.
  const auto g_at = [](const auto& g) {
    return largest([&](double degrees) { return g(at(0.8 * degrees), at(degrees)); });
  };
  return {{"Beckmann over 4 m^2 cos^4", projected_area(beckmann_over_4), projected_area(library_d),
           1, 1e-5, false, 0.785},
          {"F D G / (n.v)", exchanged(printed_cook_torrance), exchanged(library_f), 1, 1e-9, false,
           2.75, 5e-3},
          {"G = (1, Gm, Gs)", g_at(printed_g), g_at(library_g), 1, 1e-9, true},
          {"h = s + v", sum(kNormal, kNormal).z, library_n_h(), 1, 1e-9, false, 2}};
}

// The share of the hemisphere for which g is negative.
double negative_share(const std::function<double(const Vector&)>& g) {
  constexpr int kSteps = 100;
  int negative = 0;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const double z = (i / kSteps + 0.5) / kSteps, phi = (i % kSteps + 0.5) * 360 / kSteps;
    if (g(at(std::acos(z) / kDegree, phi)) < 0) ++negative;
  }
  return static_cast<double>(negative) / (kSteps * kSteps);
}

std::vector<Erratum> blinn_phong_errata() {
  constexpr double kExponent = 8.75;
  const MaterialSpec spec = alone("blinn_phong", {{"s", number(kExponent)}});
  const auto printed = [](const Vector& wo) {
    const double n_h = normalized(sum(kNormal, wo)).z;
    return (kExponent + 8) / (8 * kPi) * std::pow(n_h, kExponent);
  };
  const auto library = [&](const Vector& wo) { return f(spec, kNormal, wo); };
  return {
      {"(s + 8) / (8 pi)", projected_area(printed), projected_area(library), 1, 1e-5, true, 1.075}};
}

std::vector<Erratum> phong_errata() {
  const Vector wi = at(60);
  const MaterialSpec linear = alone("phong", {{"s", number(1)}});
  const auto printed = [&](const Vector& wo) { return wi.z * wo.z - wi.x * wo.x - wi.y * wo.y; };
  const auto library = [&](const Vector& wo) { return f(linear, wi, wo); };
  const MaterialSpec mix = alone("phong_mix", {{"s", number(1)}, {"mix", number(0)}});
  const auto library_mix = [&](const Vector& wo) { return f(mix, wi, wo); };
  const double share = negative_share(printed);
  return {{"(wr.wo)^s without a clamp", share, negative_share(library), 0, 0, true, 1. / 3, 5e-3},
          {"the same in the mix", share, negative_share(library_mix), 0, 0, true, 1. / 3, 5e-3}};
}

class Errata : public ::testing::TestWithParam<std::vector<Erratum> (*)()> {};

TEST_P(Errata, PrintedFormFailsAndTheLibraryPasses) { expect_mended(GetParam()()); }

TEST(FresnelErrata, FresnelAt75DegreesIsThatOfTheHalfVector) {
  EXPECT_NEAR(library_fresnel(kGlass, at(75), kNormal), 0.044, 5e-4);
}

INSTANTIATE_TEST_SUITE_P(OfThePublications, Errata,
                         ::testing::Values(fresnel_errata, lobe_errata, phong_errata,
                                           blinn_phong_errata));

}  // namespace
}  // namespace gonio::testing
