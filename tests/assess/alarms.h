// False alarms: how often an assessment of a good material fails for the choice of its samples.
// For tests/assess and assess_bench. Thread safety: functions without state.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gonio/engine/material.h"

namespace gonio::testing {

struct GoodMaterial {
  std::string name;
  std::function<Material()> make;
};
// Every model of the registry, as it is without parameters.
std::vector<GoodMaterial> good_models();
// The measured materials that fits are judged by; none without $GONIO_DATA.
std::vector<GoodMaterial> good_tables();

struct Alarms {
  std::uint64_t failed = 0;  // assessments
  std::uint64_t distribution = 0, sampled_albedo = 0, others = 0;
  double least_probability = 1, largest_deviation = 0;
};
// Assessments with the seeds 1 ... `seeds`, by their default limits. What is integrated is kept
// from one to the next; places, whose bounds hold for every pair, are not looked at.
Alarms alarms_of(const Material& material, std::uint64_t seeds);

}  // namespace gonio::testing
