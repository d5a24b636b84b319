// The materials that a selection tries: every model of the registry that can be fitted, in every
// combination of its words, alone, over the plainest diffuse model and, where a lobe has one shape,
// as two lobes over that; anisotropic models once with their two numbers held equal and once with
// both free. The fit turns the axes of the latter to those of the reference. The cost is that of
// the unturned kernels; a turned material costs a twentieth to a fifth more.
#pragma once

#include <string>
#include <vector>

#include "gonio/engine/material.h"
#include "select/scene.h"

namespace gonio::select {

struct Candidate {
  std::string name;                // "lambertian + 2 ggx:schlick", "ward, anisotropic"
  std::vector<std::string> parts;  // "lambertian", "ggx:schlick", "ggx:schlick"
  MaterialSpec form;               // models and words, no numbers
  bool anisotropic = false;
  std::size_t parameters = 0;  // the count of numbers that a fit chooses, of all channels
};

// In the order of the registry. `lobes`: at most 1 or 2 specular lobes.
std::vector<Candidate> candidates(const Scene& scene, int channels, int lobes);

// The material with colours of so many channels, and the start values of its models.
MaterialSpec with_channels(const MaterialSpec& form, int channels);

}  // namespace gonio::select
