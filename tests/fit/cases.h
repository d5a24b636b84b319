// A material of every model, Fresnel term and word that fits know.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "gonio/engine/material.h"

namespace gonio::testing {

// A material, and how it is fitted.
struct Case {
  std::string name;
  MaterialSpec truth;
  bool anisotropic = false;
};
inline void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

inline LobeSpec lambertian() {
  return {"lambertian", {{"rd", std::vector<double>{0.3, 0.1, 0.05}}}};
}

inline MaterialSpec over_base(LobeSpec lobe) { return {{}, lambertian(), {std::move(lobe)}}; }

inline Case with_fresnel(const std::string& model, LobeSpec lobe, const std::string& fresnel) {
  if (fresnel == "none") lobe.parameters["scale"] = std::vector<double>{0.3, 0.2, 0.1};
  if (fresnel == "schlick") {
    lobe.parameters["f0"] = std::vector<double>{0.5, 0.3, 0.1};
    lobe.parameters["scale"] = std::vector<double>{0.8, 0.9, 1.2};
  }
  if (fresnel == "dielectric") {
    lobe.parameters["eta"] = std::vector<double>{1.7};
    lobe.parameters["scale"] = std::vector<double>{2, 1, 0.5};
  }
  if (fresnel == "conductor") {
    lobe.parameters["eta"] = std::vector<double>{0.4};
    lobe.parameters["k"] = std::vector<double>{2.5};
  }
  lobe.parameters["fresnel"] = fresnel;
  return {model + "_" + fresnel, over_base(std::move(lobe))};
}

inline std::vector<Case> cases() {
  std::vector<Case> all;
  const std::vector<LobeSpec> lobes{
      {"cook_torrance", {{"m", std::vector<double>{0.2}}}},
      {"cook_torrance", {{"s", std::vector<double>{80}}, {"distribution", "cosine_power"}}},
      {"phong", {{"s", std::vector<double>{40}}}},
      {"blinn_phong", {{"s", std::vector<double>{300}}}},
      {"phong_mix", {{"s", std::vector<double>{60}}, {"mix", std::vector<double>{0.3}}}},
      {"ggx", {{"alpha_x", std::vector<double>{0.15}}, {"alpha_y", std::vector<double>{0.15}}}}};
  for (const LobeSpec& lobe : lobes) {
    const std::string name =
        lobe.model + (lobe.parameters.contains("distribution") ? "_cosine_power" : "");
    for (const char* fresnel : {"none", "schlick", "dielectric", "conductor"})
      all.push_back(with_fresnel(name, lobe, fresnel));
  }
  all.push_back({"ggx_anisotropic",
                 over_base({"ggx",
                            {{"alpha_x", std::vector<double>{0.1}},
                             {"alpha_y", std::vector<double>{0.4}},
                             {"f0", std::vector<double>{0.9, 0.6, 0.3}},
                             {"fresnel", "schlick"}}}),
                 true});
  all.push_back({"ward_anisotropic",
                 over_base({"ward",
                            {{"alpha_x", std::vector<double>{0.1}},
                             {"alpha_y", std::vector<double>{0.3}},
                             {"rs", std::vector<double>{0.2, 0.1, 0.3}}}}),
                 true});
  all.push_back({"ward", over_base({"ward",
                                    {{"alpha_x", std::vector<double>{0.2}},
                                     {"alpha_y", std::vector<double>{0.2}},
                                     {"rs", std::vector<double>{0.2}}}})});
  all.push_back({"ashikhmin_shirley_anisotropic",
                 over_base({"ashikhmin_shirley",
                            {{"nu", std::vector<double>{20}},
                             {"nv", std::vector<double>{500}},
                             {"rs", std::vector<double>{0.2, 0.3, 0.6}}}}),
                 true});
  all.push_back({"ashikhmin_shirley_alone",
                 {LobeSpec{"ashikhmin_shirley",
                           {{"nu", std::vector<double>{100}},
                            {"nv", std::vector<double>{100}},
                            {"rd", std::vector<double>{0.5, 0.3, 0.2}},
                            {"rs", std::vector<double>{0.1, 0.05, 0.2}}}},
                  {},
                  {}}});
  all.push_back({"lambertian", {lambertian(), {}, {}}});
  for (const char* form : {"full", "short"}) {
    all.push_back({std::string("oren_nayar_") + form,
                   {LobeSpec{"oren_nayar",
                             {{"rd", std::vector<double>{0.7, 0.4, 0.2}},
                              {"sigma", std::vector<double>{0.5}},
                              {"form", form}}},
                    {},
                    {}}});
  }
  MaterialSpec two = over_base({"ggx",
                                {{"alpha_x", std::vector<double>{0.4}},
                                 {"alpha_y", std::vector<double>{0.4}},
                                 {"scale", std::vector<double>{0.2}},
                                 {"fresnel", "none"}}});
  two.specular.push_back({"ggx",
                          {{"alpha_x", std::vector<double>{0.05}},
                           {"alpha_y", std::vector<double>{0.05}},
                           {"scale", std::vector<double>{0.05, 0.04, 0.03}},
                           {"fresnel", "none"}}});
  all.push_back({"two_lobes", two});
  return all;
}

}  // namespace gonio::testing
