// The axes of an anisotropic material: by how much its tangents are turned from those of the data's
// frame.
//
// A search first holds the axes along the frame's. Only where what is left has a pattern along
// sin(2 phi_h), which no such material can explain, does another go on with the rotation as one
// more shape (pattern.h): isotropic data, and those along the frame, cost no second search, and
// their result is the first's.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/search/search.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

// A rotation of a larger standard error says little. By chance alone a lobe is anisotropic by about
// one standard error, and the rotation's is then some 30 degrees.
inline constexpr double kVagueDegrees = 8;

// The same material as `shapes` (search scale or natural; what follows them is kept), by the
// rotation that is nearest to that of `like`: each quarter of a turn swaps what belongs to u and v.
std::vector<double> near_turn(const Form& form, std::span<const double> like,
                              std::span<const double> shapes);

// A form, with all it says but of shapes, and the shapes of another of the same lobes.
Form with_shapes(const Form& form, const Form& of);

// The search on, with the rotation as a shape, where it gains. `turned`: the input's form with that
// shape. None where the axes stay where they are.
std::optional<Search> search_turned(const SearchInput& aligned, const SearchInput& turned,
                                    const Search& found);

// Of a fit whose axes were left along the frame's: how well the data say so, as one more parameter
// of the report; nothing where the lobe is isotropic within its error.
void add_aligned(const SearchInput& turned, std::span<const double> aligned, Certificate& report);

// Of a fit that is isotropic, or whose rotation was given: what anisotropy would explain, in words
// after the verdict's reason.
void add_hint(const SearchInput& input, const MaterialSpec& form,
              std::span<const double> parameters, Certificate& report);

}  // namespace gonio::fit
