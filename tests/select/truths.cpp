// The materials of the trials: drawn at random, each a clear case of its model.
#include <utility>

#include "select/trials.h"

namespace gonio::testing {
namespace {

using Numbers = std::vector<double>;

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
  lobe.parameters["fresnel"] = std::string("none");
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

}  // namespace gonio::testing
