// What a lobe reflects in one channel, as its model's table has it, and the coefficients by which a
// fit has it: the one place that knows how the two belong together.
//
// Coefficients are linear in f, and so easy to solve for; the table bounds colours. Where a bound
// holds an optimum, colours are what is searched: there every bound is an interval of one number.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace gonio {
struct Parameter;  // models/description.h
}

namespace gonio::fit {

// Where a lobe's coefficients come from and go to. With the lobe's height at h = n taken out:
enum class Columns {
  diffuse,            // rd
  quadratic_diffuse,  // rd, whose square has a column, too
  scaled,             // scale
  reflectance,        // scale rs, which only their product tells
  schlick,            // scale f0, scale (1 - f0)
  ashikhmin_shirley   // scale rs, scale (1 - rs) and, alone, rd (1 - rs)
};

// A lobe that has no `reflectance` or `diffuse` term of its own ignores it. Of Columns::reflectance
// `scale` is the product of scale and rs.
struct Colour {
  double scale = 0, reflectance = 0, diffuse = 0;
};
using ColourMember = double Colour::*;

// As many members as the lobe has coefficients, in an order of their own.
std::span<const ColourMember> members_of(Columns columns, std::size_t coefficients);
// As the table names a member: "scale", "f0", ...
std::string_view name_of(Columns columns, ColourMember member);

// `coefficients`, and the result: with the lobe's height at h = n taken out. Without a lobe its
// reflectance is 0.
Colour colour_of(Columns columns, std::span<const double> coefficients);
std::array<double, 3> coefficients_of(Columns columns, const Colour& colour);

// d coefficients_of / d member.
std::array<double, 3> slopes_of(Columns columns, const Colour& colour, ColourMember member);

// The bounds of a model's table.
struct ColourBounds {
  Colour lower, upper;
};
ColourBounds colour_bounds(Columns columns, std::span<const Parameter> parameters);

}  // namespace gonio::fit
