#include "fit/search/shape.h"

#include <algorithm>
#include <cmath>

#include "gonio/engine/material.h"

namespace gonio::fit {
namespace {

// Where a refractive index is searched, and how closely it may come to 1: at 1 + 1e-3 a lobe's
// reflectance is its limit for an index of 1 to a thousandth, and its scale still within bounds.
constexpr double kLeastEta = 1 + 1e-3;
// What is added to a logarithmic parameter that may be 0: near 0 its scale is linear.
constexpr double kLogOffset = 1;

constexpr double kLeastScannedExponent = 0.3;

}  // namespace

double SearchScale::to_parameter(double u) const { return logarithmic ? offset + std::exp(u) : u; }
double SearchScale::to_search(double p) const { return logarithmic ? std::log(p - offset) : p; }
double SearchScale::slope(double u) const { return logarithmic ? std::exp(u) : 1; }

ShapeParameter shape_of(const Parameter& p, bool dielectric) {
  ShapeParameter shape{};
  shape.names = {std::string(p.name)};
  shape.lower = p.lower;
  shape.upper = p.upper;
  shape.scale.logarithmic = p.scale == Scale::logarithmic;
  if (shape.scale.logarithmic && p.lower <= 0) shape.scale.offset = -kLogOffset;
  shape.scan_lower = p.lower;
  shape.scan_upper = p.upper;
  // At an exponent of 0 a lobe has no shape to descend by; a descent may still go there.
  if (shape.scale.offset < 0) shape.scan_lower = kLeastScannedExponent;
  if (p.name == "eta" && dielectric) {
    shape.scale.offset = 1;
    shape.lower = kLeastEta;
    shape.scan_lower = 1.005;
  } else if (p.name == "eta") {
    shape.scan_lower = 0.1;
    shape.scan_upper = 10;
  } else if (p.name == "k") {
    shape.scale = {true, -kLogOffset};
    shape.scan_lower = 0;
    shape.scan_upper = 10;
  }
  shape.start = std::clamp(p.start, shape.lower, shape.upper);
  return shape;
}

ShapeParameter rotation_shape(std::size_t lobe) {
  constexpr double kScanned = 30;  // either way: nodes next to the ends would be the same
  ShapeParameter shape = shape_of(kRotation, false);
  shape.lobe = lobe;
  shape.field = kRotation.name;
  shape.scan_lower = -kScanned;
  shape.scan_upper = kScanned;
  return shape;
}

}  // namespace gonio::fit
