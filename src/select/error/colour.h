// Differences of colour as people see them.
#pragma once

namespace gonio::select {

// CIE L*a*b* for the white of D65.
struct Lab {
  double l = 0, a = 0, b = 0;
};

// Of linear sRGB (IEC 61966-2-1), 1 for white. As a picture shows it: what is below 0 is black, and
// what is brighter than white is white.
Lab lab_of(double red, double green, double blue);

// CIEDE2000 (ISO/CIE 11664-6), all its factors 1: about 1 is just seen. The same for x, y and y, x.
double delta_e(const Lab& x, const Lab& y);

}  // namespace gonio::select
