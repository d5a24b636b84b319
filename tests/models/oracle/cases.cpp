#include "models/oracle/cases.h"

#include <sstream>
#include <stdexcept>

#include "gonio/engine/registry.h"
#include "models/harness/analytic_models.h"

namespace gonio::testing {
namespace {

using Colour = std::vector<double>;

std::string text(double v) {
  std::ostringstream out;
  out << v;
  return out.str();
}

Colour spectrum(std::size_t count, double from, double to) {
  Colour values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  return values;
}

std::vector<Case> lambertian_cases() {
  const auto with = [](std::string name, Colour rd) {
    return Case{std::move(name), Sharpness::smooth, alone("lambertian", {{"rd", std::move(rd)}})};
  };
  return {with("black", {0}), with("grey", {0.5}), with("white", {1}), with("rgb", {0.1, 0.5, 0.9}),
          with("64 channels", spectrum(64, 0, 1))};
}

std::vector<Case> ashikhmin_shirley_cases() {
  struct Set {
    double nu, nv;
    Colour rd, rs;
    double scale = 1;
  };
  const Colour copper{0.95, 0.64, 0.54};
  const std::vector<Set> sets{{0, 0, {0}, {1}},
                              {1, 1, {0.5}, {0.05}},
                              {10, 10, {0}, {0}},
                              {10, 1000, {0}, copper},
                              {100, 100, {0}, {0.5}},
                              {0, 1000, {0.2, 0.3, 0.4}, {0.04}},
                              {1000, 1000, {0}, {1}, 3},
                              {1000, 1000, {0}, {0}},
                              {1000, 900, copper, copper, 0},
                              {1e4, 1e4, {0}, {0.05}},
                              {1e5, 10, {0}, copper},
                              {0, 1e6, {0}, {0.5}},
                              {1e6, 1e6, {0}, {0}},
                              {1e6, 1e6, {0}, {1}},
                              {1e6, 1e3, {0.5}, {0.05}},
                              {1e6, 1e5, {0}, spectrum(31, 0, 1)},
                              {1e8, 1e8, {0}, {0.5}},
                              {1e8, 1, {0}, {0}}};
  std::vector<Case> cases;
  for (const auto& [nu, nv, rd, rs, scale] : sets) {
    const double n = std::max(nu, nv);
    cases.push_back({"nu " + text(nu) + " nv " + text(nv) + (rd == Colour{0} ? " bare" : ""),
                     n <= 1e3   ? Sharpness::smooth
                     : n <= 1e6 ? Sharpness::sharp
                                : Sharpness::extreme,
                     alone("ashikhmin_shirley", {{"nu", number(nu)},
                                                 {"nv", number(nv)},
                                                 {"rd", rd},
                                                 {"rs", rs},
                                                 {"scale", number(scale)}})});
  }
  return cases;
}

struct Reflectance {
  std::string name;
  Parameters parameters;
};

// Every kind, and where each is hard: no and full reflectance, total reflection, an index near 1.
std::vector<Reflectance> reflectances() {
  std::vector<Reflectance> all{{"none", {}}, {"none by word", {{"fresnel", "none"}}}};
  for (const Colour& f0 : {Colour{0}, Colour{0.04}, Colour{1}, Colour{0.95, 0.64, 0.54}}) {
    all.push_back({"schlick f0 " + text(f0[0]), {{"f0", f0}}});
  }
  for (const double eta :
       {1.5, 1.0, 1.000001, 0.999999, 1.001, 1.05, 1 / 1.5, 0.2, 0.01, 2.4, 100.0}) {
    all.push_back({"dielectric " + text(eta), {{"eta", number(eta)}, {"fresnel", "dielectric"}}});
  }
  all.push_back({"dielectric by channel", {{"eta", spectrum(16, 0.5, 2.5)}}});
  struct Metal {
    Colour eta, k;
  };
  for (const Metal& metal :
       {Metal{{0.2, 0.92, 1.1}, {3.9, 2.45, 2.4}}, Metal{{1.5}, {0}}, Metal{{1.5}, {1e-4}},
        Metal{{0.7}, {0}}, Metal{{0.7}, {1e-6}}, Metal{{1}, {1e-3}}, Metal{{0.01}, {100}},
        Metal{{100}, {0.5}}, Metal{{1.0001}, {0}}}) {
    all.push_back({"conductor " + text(metal.eta[0]) + " " + text(metal.k[0]),
                   {{"eta", metal.eta}, {"k", metal.k}}});
  }
  return all;
}

struct Shape {
  std::string name;
  Sharpness sharpness;
  Parameters parameters;
};

Case with_reflectance(const std::string& model, const Shape& shape,
                      const Reflectance& reflectance) {
  Parameters parameters = shape.parameters;
  parameters.insert(reflectance.parameters.begin(), reflectance.parameters.end());
  return {shape.name + ", " + reflectance.name, shape.sharpness,
          alone(model, std::move(parameters))};
}

// Each shape bare and with one reflectance, in turn.
std::vector<Case> lobe_cases(const std::string& model, const std::vector<Shape>& shapes) {
  const std::vector<Reflectance> all = reflectances();
  std::vector<Case> cases;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    cases.push_back(with_reflectance(model, shapes[i], all[0]));
    cases.push_back(with_reflectance(model, shapes[i], all[(5 * i) % all.size()]));
  }
  return cases;
}

// The same, and the first shape with every reflectance.
std::vector<Case> microfacet_cases(const std::string& model, const std::vector<Shape>& shapes) {
  std::vector<Case> cases = lobe_cases(model, shapes);
  for (const Reflectance& reflectance : reflectances()) {
    cases.push_back(with_reflectance(model, shapes[0], reflectance));
  }
  return cases;
}

// Phong exponents from 0 to the sharpest, with what else a lobe needs.
std::vector<Shape> exponent_shapes(const Parameters& others = {}) {
  std::vector<Shape> shapes;
  for (const double s : {100.0, 0.0, 0.3, 1.0, 10.0, 1e3, 1e4, 1e6, 1e7}) {
    Parameters parameters = others;
    parameters["s"] = number(s);
    shapes.push_back({"s " + text(s),
                      s <= 1e3   ? Sharpness::smooth
                      : s <= 1e6 ? Sharpness::sharp
                                 : Sharpness::extreme,
                      std::move(parameters)});
  }
  return shapes;
}

std::vector<Case> cook_torrance_cases() {
  std::vector<Shape> shapes;
  for (const double m : {0.3, 2.0, 1.0, 0.5, 0.1, 0.045, 0.01, 0.003, 0.001}) {
    shapes.push_back(
        {"m " + text(m), m >= 0.045 ? Sharpness::smooth : Sharpness::sharp, {{"m", number(m)}}});
  }
  for (Shape& shape : exponent_shapes()) shapes.push_back(std::move(shape));
  return microfacet_cases("cook_torrance", shapes);
}

// Roughness along both tangents.
std::vector<Shape> rough_shapes() {
  struct Roughness {
    double x, y;
  };
  std::vector<Shape> shapes;
  for (const auto& [x, y] : {Roughness{0.3, 0.3},
                             {1, 1},
                             {0.1, 0.4},
                             {1, 0.05},
                             {0.05, 0.05},
                             {0.01, 0.3},
                             {0.01, 0.01},
                             {0.001, 0.001},
                             {0.001, 1},
                             {0.5, 0.002}}) {
    shapes.push_back({"alpha " + text(x) + " " + text(y),
                      std::min(x, y) >= 0.045 ? Sharpness::smooth : Sharpness::sharp,
                      {{"alpha_x", number(x)}, {"alpha_y", number(y)}}});
  }
  return shapes;
}

std::vector<Case> ward_cases() {
  std::vector<Case> cases;
  for (Shape& shape : rough_shapes()) {
    shape.parameters["rs"] = Colour{0, 0.37, 1};
    cases.push_back({shape.name, shape.sharpness, alone("ward", std::move(shape.parameters))});
  }
  return cases;
}

std::vector<Case> phong_mix_cases() {
  std::vector<Shape> shapes;
  for (const double mix : {0.3, 0.0, 1.0}) {
    for (Shape& shape : exponent_shapes({{"mix", number(mix)}})) {
      shape.name += " mix " + text(mix);
      shapes.push_back(std::move(shape));
    }
  }
  return lobe_cases("phong_mix", shapes);
}

std::vector<Case> oren_nayar_cases() {
  std::vector<Case> cases;
  for (const std::string form : {"full", "short"}) {
    for (const double sigma : {0.3, 0.0, 1e-3, 0.7, 0.8, 1.5707963267948966}) {
      cases.push_back(
          {form + " sigma " + text(sigma), Sharpness::smooth,
           alone("oren_nayar",
                 {{"form", form}, {"sigma", number(sigma)}, {"rd", Colour{0.01, 0.5, 1}}})});
    }
  }
  return cases;
}

// Sums take their parts with their own parameters; channels spread over one and many.
std::vector<Case> sum_cases() {
  const auto part = [](std::string model, Parameters parameters) {
    return LobeSpec{std::move(model), std::move(parameters)};
  };
  const LobeSpec grey = part("lambertian", {{"rd", number(0.3)}});
  const LobeSpec rgb = part("lambertian", {{"rd", Colour{0.1, 0.2, 0.3}}});
  const LobeSpec coat = part("ggx", {{"alpha_x", number(0.1)},
                                     {"alpha_y", number(0.2)},
                                     {"eta", number(1.5)},
                                     {"scale", number(0.5)}});
  const LobeSpec metal =
      part("cook_torrance", {{"m", number(0.2)}, {"f0", Colour{0.95, 0.64, 0.54}}});
  const LobeSpec brushed = part("ashikhmin_shirley", {{"nu", number(1000)},
                                                      {"nv", number(10)},
                                                      {"rd", number(0)},
                                                      {"rs", number(0.4)},
                                                      {"scale", Colour{1, 0.5, 0.25}}});
  const auto sum = [](std::string name, std::optional<LobeSpec> diffuse,
                      std::vector<LobeSpec> specular) {
    return Case{std::move(name), Sharpness::smooth, {{}, std::move(diffuse), std::move(specular)}};
  };
  return {sum("diffuse alone", grey, {}), sum("one lobe", {}, {coat}),
          sum("grey base, coloured metal", grey, {metal}),
          sum("two of one model", rgb, {coat, coat}),
          sum("four lobes", rgb, {coat, metal, brushed, coat})};
}

// Some of the cases again with their tangents turned; one of a model that has none.
void add_turned(std::vector<Case>& cases, bool has_tangents) {
  const std::size_t given = cases.size(), step = given / 5;
  std::vector<double> angles{30, -117.3, 90, 1e-3, 180};
  if (!has_tangents) angles.resize(1);
  for (std::size_t k = 0; k < angles.size(); ++k) {
    Case turned = cases[(k * step + step / 2) % given];
    turned.name += ", turned by " + text(angles[k]);
    turned.spec.rotation = angles[k];
    cases.push_back(std::move(turned));
  }
}

std::vector<Case> unturned_cases_of(std::string_view model) {
  if (model == "lambertian") return lambertian_cases();
  if (model == "ashikhmin_shirley") return ashikhmin_shirley_cases();
  if (model == "cook_torrance") return cook_torrance_cases();
  if (model == "ggx") return microfacet_cases("ggx", rough_shapes());
  if (model == "phong") return lobe_cases("phong", exponent_shapes());
  if (model == "blinn_phong") return lobe_cases("blinn_phong", exponent_shapes());
  if (model == "phong_mix") return phong_mix_cases();
  if (model == "oren_nayar") return oren_nayar_cases();
  if (model == "ward") return ward_cases();
  if (model == "sum") return sum_cases();
  throw std::out_of_range("no cases for the model " + std::string(model));
}

}  // namespace

std::vector<std::string> models_with_cases() {
  std::vector<std::string> names = analytic_models();
  names.insert(names.begin(), "sum");
  return names;
}

std::vector<Case> cases_of(std::string_view model) {
  std::vector<Case> cases = unturned_cases_of(model);
  add_turned(cases, model == "sum" || (*find_model(model))->has_tangents());
  return cases;
}

}  // namespace gonio::testing
