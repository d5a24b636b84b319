// What a lobe reflects in one channel, as its model's table has it, and the coefficients by which a
// fit has it: the one place that knows how the two belong together.
//
// Coefficients are linear in f, and so easy to solve for; the table bounds colours. Where a bound
// holds an optimum, colours are what is searched: there every bound is an interval of one number.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gonio {
struct Parameter;  // models/description.h
}

namespace gonio::fit {

// Where a lobe's coefficients come from and go to. With the lobe's height at h = n taken out, and
// by what the table says that colours are (Quantity, Dependence):
enum class Columns : std::uint8_t {
  diffuse,            // a base colour
  quadratic_diffuse,  // a base colour, whose square has a column, too
  scaled,             // an amplitude, a reflectance, or the product of both, which alone is told
  affine,             // amplitude times reflectance, amplitude times (1 - reflectance)
  affine_over_base    // these, and a base colour times (1 - reflectance)
};

// Only a base colour, with one coefficient and no height of a lobe?
inline bool is_diffuse(Columns columns) {
  return columns == Columns::diffuse || columns == Columns::quadratic_diffuse;
}

// A lobe that has no `reflectance` or `diffuse` term of its own ignores it. Of Columns::scaled
// `scale` is the product of amplitude and reflectance.
struct Colour {
  double scale = 0, reflectance = 0, diffuse = 0;
};
using ColourMember = double Colour::*;

// The bounds of a model's table.
struct ColourBounds {
  Colour lower, upper;
};

// The parameters of a model that are the colours of one lobe; null where it has none.
struct LobeColours {
  Columns columns = Columns::scaled;
  // Of Columns::scaled the amplitude, or a reflectance that stands alone.
  const Parameter* scale = nullptr;
  const Parameter* reflectance = nullptr;
  const Parameter* diffuse = nullptr;

  // Those of Colour that the lobe has, one for each of its coefficients, in an order of their own.
  [[nodiscard]] std::span<const ColourMember> members() const;
  [[nodiscard]] const Parameter& parameter(ColourMember member) const;
  [[nodiscard]] ColourBounds bounds() const;
};

// `coefficients`, and the result: with the lobe's height at h = n taken out. Without a lobe its
// reflectance is 0.
Colour colour_of(Columns columns, std::span<const double> coefficients);
std::array<double, 3> coefficients_of(Columns columns, const Colour& colour);

// d coefficients_of / d member.
std::array<double, 3> slopes_of(Columns columns, const Colour& colour, ColourMember member);

}  // namespace gonio::fit
