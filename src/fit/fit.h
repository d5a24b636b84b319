// Fits a material to measured reflectance, and says how far the result can be trusted.
//
//   auto data = fit::from_table(*MeasuredTable::read_merl("nickel.binary").value());
//   MaterialSpec form;                        // what is fitted; numbers in it are a first guess
//   form.diffuse = {"lambertian", {}};
//   form.specular = {{"cook_torrance", {{"fresnel", "dielectric"}}}};
//   auto result = fit::fit(data, form, {});   // result->material
//
// Shape parameters (exponents, roughness, refractive indices) are shared by the channels; colours
// and amplitudes are each channel's own; the models' tables say which is which. The result is the
// same for the same data, options and instruction set, whatever the number of threads: one fit runs
// on the thread that calls it, and any number may run side by side.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/data/data.h"
#include "fit/linear/objective.h"
#include "gonio/base/result.h"
#include "gonio/engine/material.h"
#include "gonio/fit/certificate.h"

namespace gonio::fit {

enum class Strategy : std::uint8_t {
  automatic,  // a scan, descents from its most distinct nodes, the best two on more pairs
  staged,     // Nielsen et al. 2014: colours; then shapes; then lobes; from the one guess
};

struct Options {
  Objective objective = Objective::l1;
  Strategy strategy = Strategy::automatic;
  // What belongs to the tangents u and v each by itself, and along which axes (rotation.h), unless
  // the form gives a rotation or the strategy is staged.
  bool anisotropic = false;
  bool cosine = true;    // residuals are of f cos(theta_i), or of f
  double huber = 0.1;    // Huber's threshold, as a part of the mean of m cos
  double min_theta = 0;  // radians; pairs whose larger angle is in (min, max] are fitted
  double max_theta = 1.5707963267948966;
  // Nodes of the scan that are descended from, beside the models' own start, the guess and, where a
  // bound holds a shape, some with that shape held.
  std::size_t starts = 6;
  std::size_t fit_pairs = 20'000, scan_pairs = 2'000;  // of the stratified subsets
  bool polish = false;                                 // a last descent on all pairs
  // Whether a fit that leaves an anisotropic pattern in its residuals tries an anisotropic form,
  // and says in its reason what that gains.
  bool hints = true;
  std::uint64_t seed = 1;  // of the subsets
};

struct Watch {
  std::function<void(const Progress&)> progress;  // from the fitting thread, several times a second
  std::function<bool()> stop;                     // asked often; true ends the fit with `cancelled`
};

struct FitResult {
  MaterialSpec material;
  Certificate certificate;
};

// Errors: invalid_argument naming the field (of `form` as Material::create does, or "options.…");
// cancelled. Data that say nothing are no error: the verdict is then `failed` with the reason.
Result<FitResult> fit(const Data& data, const MaterialSpec& form, const Options& options,
                      const Watch& watch = {});

}  // namespace gonio::fit
