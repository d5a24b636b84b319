#include "fit/search/shape.h"

#include <algorithm>
#include <cmath>

#include "gonio/engine/material.h"

namespace gonio::fit {
namespace {

// How closely the refractive index of a dielectric may come to 1: at 1 + 1e-3 a lobe's reflectance
// is its limit for an index of 1 to a thousandth, and its amplitude still within bounds. A scan
// looks from somewhat above.
constexpr double kLeastIndex = 1 + 1e-3, kLeastScannedIndex = 1.005;
// Where a scan looks for a conductor's index and extinction: known substances have less.
constexpr double kConductorLower = 0.1, kConductorUpper = 10;
// What is added to a logarithmic parameter that may be 0: near 0 its scale is linear.
constexpr double kLogOffset = 1;
// At an exponent of 0 a lobe has no shape to descend by; a descent may still go there.
constexpr double kLeastScannedExponent = 0.3;

void set_index(bool dielectric, ShapeParameter& shape) {
  if (dielectric) {
    shape.scale.offset = 1;
    shape.lower = kLeastIndex;
    shape.scan_lower = kLeastScannedIndex;
  } else {
    shape.scan_lower = kConductorLower;
    shape.scan_upper = kConductorUpper;
  }
}

void set_extinction(ShapeParameter& shape) {
  shape.scale = {true, -kLogOffset};
  shape.scan_lower = 0;
  shape.scan_upper = kConductorUpper;
}

}  // namespace

double SearchScale::to_parameter(double u) const { return logarithmic ? offset + std::exp(u) : u; }
double SearchScale::to_search(double p) const { return logarithmic ? std::log(p - offset) : p; }
double SearchScale::slope(double u) const { return logarithmic ? std::exp(u) : 1; }

bool is_width(const ShapeParameter& shape) {
  return shape.scale.logarithmic && shape.quantity == Quantity::shape;
}

ShapeParameter shape_of(const Parameter& p, Quantity quantity, bool dielectric) {
  ShapeParameter shape{};
  shape.quantity = quantity;
  shape.names = {std::string(p.name)};
  shape.lower = p.lower;
  shape.upper = p.upper;
  shape.scale.logarithmic = p.scale == Scale::logarithmic;
  if (shape.scale.logarithmic && p.lower <= 0) shape.scale.offset = -kLogOffset;
  shape.scan_lower = p.lower;
  shape.scan_upper = p.upper;
  if (shape.scale.offset < 0) shape.scan_lower = std::min(kLeastScannedExponent, p.start);
  if (quantity == Quantity::refractive_index) set_index(dielectric, shape);
  if (quantity == Quantity::extinction) set_extinction(shape);
  shape.start = std::clamp(p.start, shape.lower, shape.upper);
  return shape;
}

ShapeParameter rotation_shape(std::size_t lobe) {
  constexpr double kScanned = 30;  // either way: nodes next to the ends would be the same
  ShapeParameter shape = shape_of(kRotation, Quantity::shape, false);
  shape.lobe = lobe;
  shape.field = kRotation.name;
  shape.scan_lower = -kScanned;
  shape.scan_upper = kScanned;
  return shape;
}

}  // namespace gonio::fit
