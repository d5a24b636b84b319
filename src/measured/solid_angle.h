// What part of all pairs of directions each of a goniometer's measurements stands for.
//
// A goniometer holds the light and moves the detector over the hemisphere, often closer about a
// lobe than elsewhere: without weights such a lobe would count for more than it is. Thread safety:
// functions without state.
#pragma once

#include <span>
#include <vector>

namespace gonio {

// In sr^2, for interleaved xyz of unit directions. For each wi: the directions of the hemisphere
// that are nearer to one of its wo than to any other, up to 15 degrees away, on a grid of half a
// degree (above 200 wi a coarser one, so that a hundred thousand wi take seconds too); times the
// zone of incidence that the wi stands for, half way to the next. (Where all wi lie in one plane
// with the normal the surface is taken as isotropic.) Empty where most wi have fewer than 8 wo: the
// data are scattered otherwise, and nothing is said of them.
std::vector<double> pair_measures(std::span<const double> wi, std::span<const double> wo);

// The same for one set of directions, in sr: those within 15 degrees that are nearest to each. 0
// for a direction that is not finite or not above the horizon.
std::vector<double> solid_angles(std::span<const double> directions);

}  // namespace gonio
