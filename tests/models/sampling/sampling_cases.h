// Where samplers are held to their word: materials drawn from the models' own tables, so that a
// model added to the registry is tested without a line here, and angles of incidence.
#pragma once

#include <string>
#include <vector>

#include "models/harness/hemisphere.h"
#include "models/oracle/draws.h"

namespace gonio::testing {

struct Place {
  std::string name;
  MaterialSpec spec;
  Direction wi;
  std::uint64_t seed;
};

// Of a model of the registry, or of "sum".
std::vector<Place> places_of(const std::string& model);

// All of them: how many tests share the level of significance.
std::size_t count_of_places();

// The unit direction at this colatitude and azimuth (degrees), its components those of float32, so
// that every precision is given the same.
Direction incidence(double theta, double phi);

}  // namespace gonio::testing
