// Parameters that papers published for MERL's materials ($GONIO_DATA/published_fits), as materials.
//
// Conventions, checked against values known for them: Loew et al. 2012 give Cook & Torrance's lobe
// with an exact dielectric Fresnel and a prefactor of 1/pi (four of ours), and Ashikhmin &
// Shirley's with the normal reflectance of an index; Ngan et al. 2005 give Schlick's F0, and
// colours that lack MERL's factors on green and blue. What Ngan's Cook & Torrance lobe is divided
// by can be read in two ways: 4 n.wi n.wo, or pi n.wi n.wo. Neither is better for all materials, so
// both are given.
#pragma once

#include <array>
#include <fstream>
#include <numbers>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "data_folder.h"
#include "gonio/engine/material.h"

namespace gonio::testing {

struct PublishedLine {
  std::string text;  // the part after "NAME = "

  // The numbers of "field = 1.5" or "field = [1, 2, 3]", the `which`-th time that it appears.
  [[nodiscard]] std::vector<double> numbers(const std::string& field, int which = 0) const {
    const std::regex wanted(field + R"( = (\[[^\]]*\]|[-+.eE0-9]+))");
    auto at = std::sregex_iterator(text.begin(), text.end(), wanted);
    for (int i = 0; i < which; ++i) ++at;
    std::string list = (*at)[1];
    std::vector<double> found;
    for (char& c : list) c = c == '[' || c == ']' || c == ',' ? ' ' : c;
    std::istringstream in(list);
    for (double x = 0; in >> x;) found.push_back(x);
    return found;
  }
};

inline std::optional<PublishedLine> published_line(const std::string& table,
                                                   const std::string& material) {
  std::ifstream in(data_folder() / "published_fits" / (table + ".fit"));
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(material + " = ", 0) == 0)
      return PublishedLine{line.substr(material.size() + 3)};
  }
  return std::nullopt;
}

inline std::vector<double> times(std::vector<double> colour, const std::array<double, 3>& factor) {
  for (std::size_t c = 0; c < colour.size(); ++c) colour[c] *= factor[c];
  return colour;
}

// The published material, in all its readings; none where the table lacks it. `table` is a file's
// name without its ending.
inline std::vector<MaterialSpec> published(const std::string& table, const std::string& material) {
  const auto line = published_line(table, material);
  if (!line) return {};
  const bool ngan = table.rfind("ngan", 0) == 0;
  const bool cook = table.find("cooktorrance") != std::string::npos;
  const std::array<double, 3> factor =
      ngan ? std::array{1.0, 1.15, 1.66} : std::array{1.0, 1.0, 1.0};
  MaterialSpec spec;
  spec.diffuse = LobeSpec{"lambertian", {{"rd", times(line->numbers("albedo"), factor)}}};
  LobeSpec lobe;
  std::vector<double> scale = times(line->numbers("albedo", 1), factor);
  if (cook) {
    lobe.model = "cook_torrance";
    lobe.parameters["m"] = line->numbers("roughness");
    lobe.parameters[ngan ? "f0" : "eta"] = line->numbers("eta");
    if (!ngan) scale = times(scale, {4, 4, 4});
  } else {
    lobe.model = "ashikhmin_shirley";
    const double given = line->numbers("fresnelReflectance")[0];
    const double root = (given - 1) / (given + 1);
    lobe.parameters["rs"] = std::vector{ngan ? given : root * root};
    lobe.parameters["nu"] = lobe.parameters["nv"] = line->numbers("sharpness");
  }
  std::vector<MaterialSpec> readings;
  for (const double reading : {1.0, 4 / std::numbers::pi}) {
    lobe.parameters["scale"] = times(scale, {reading, reading, reading});
    spec.specular = {lobe};
    readings.push_back(spec);
    if (!ngan || !cook) break;
  }
  return readings;
}

}  // namespace gonio::testing
