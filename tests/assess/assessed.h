// What the tests of assessments share: materials, also such as no check would let through, and
// their reports.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "assess/assess.h"
#include "engine/material/material_impl.h"
#include "engine/material/registry.h"
#include "models/oracle/cases.h"
#include "models/oracle/run.h"

namespace gonio::testing {

// The material with one number put in after all checks: bounds forced off.
inline Material unchecked(const MaterialSpec& spec, std::string_view parameter, double value) {
  const Material checked = material_of(spec);
  auto impl = std::make_shared<Material::Impl>(checked.impl());
  CheckedLobe lobe = *impl->parts[0].lobe;
  lobe.values.set(parameter, {value});
  impl->parts[0] = make_part(lobe, impl->channels);
  return Material(std::move(impl));
}

// With a bound that the material does not keep.
inline Material with_stated_error(const MaterialSpec& spec, double relative) {
  auto impl = std::make_shared<Material::Impl>(material_of(spec).impl());
  impl->fast.relative = relative;
  return Material(std::move(impl));
}

inline assess::Subject subject_of(const Material& material) {
  return assess::subject_of(Sampler::create(material), best_isa());
}

// Of fewer pairs than by default: a test has many materials.
inline assess::Report report_of(const assess::Subject& subject, assess::Options options = {}) {
  options.pairs = std::min<std::size_t>(options.pairs, 1000);
  auto report = assess::assess(subject, options);
  EXPECT_TRUE(report.ok());
  return std::move(report).value();
}

inline const assess::Check& check_of(const assess::Report& report, std::string_view name) {
  const auto found = std::ranges::find(report.checks, name, &assess::Check::name);
  EXPECT_NE(found, report.checks.end()) << name;
  return *found;
}

inline const assess::PlaceReport& place_of(const assess::Report& report, std::string_view name) {
  const auto found = std::ranges::find(report.places, name, &assess::PlaceReport::name);
  EXPECT_NE(found, report.places.end()) << name;
  return *found;
}

// What failed, by name and in order.
inline std::vector<std::string> failed(const assess::Report& report) {
  std::vector<std::string> names;
  for (const assess::Check& check : report.checks) {
    if (!check.passed) names.emplace_back(check.name);
  }
  return names;
}

}  // namespace gonio::testing
