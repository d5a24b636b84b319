// What fit_bench's modes share. Each prints one table, and returns whether what it holds is met.
#pragma once

#include <array>
#include <string>

#include "fit/data/data.h"
#include "fit/fit.h"
#include "fit/real_data.h"
#include "fit/report/metrics.h"

namespace gonio::bench {

inline constexpr std::array kObjectives{fit::Objective::l1, fit::Objective::l2, fit::Objective::log,
                                        fit::Objective::cbrt};
// The four that independence, speed and noise are shown on; each over a diffuse base, with an exact
// dielectric's Fresnel.
inline constexpr std::array kModels{"phong", "blinn_phong", "phong_mix", "cook_torrance"};

// The first of the materials, which independence is shown on with noise, too.
inline constexpr std::size_t kNoisySets = 4;

// All cells of a measured material; ends the program, naming it, where the data are absent.
fit::Data load(const std::string& name, double noise = 0, double invalid = 0);

// The measure that an objective minimises.
double metric(const fit::Errors& errors, fit::Objective objective);

bool compare_with_published();
bool print_times(int repetitions);
bool print_independence(int starts);
bool print_noise();
bool print_coverage(int trials);
bool print_grazing();

}  // namespace gonio::bench
