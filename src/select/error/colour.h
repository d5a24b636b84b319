// Perceived differences of colour.
#pragma once

namespace gonio::select {

// CIE L*a*b* for the white of D65.
struct Lab {
  double l = 0, a = 0, b = 0;
};

// From linear sRGB (IEC 61966-2-1), 1 for white. Values are clamped as in a picture: below 0 to
// black, above 1 to white.
Lab lab_of(double red, double green, double blue);

// CIEDE2000 (ISO/CIE 11664-6), all its factors 1: about 1 is just noticeable. The same for x, y and
// y, x.
double delta_e(const Lab& x, const Lab& y);

}  // namespace gonio::select
