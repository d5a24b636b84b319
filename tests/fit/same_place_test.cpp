// Ends of descents that are one material.
#include "fit/search/same_place.h"

#include <gtest/gtest.h>

namespace gonio::testing {
namespace {

LobeSpec ggx(const char* fresnel) { return {"ggx", {{"fresnel", fresnel}}}; }

fit::Form form_of(std::vector<LobeSpec> lobes) {
  const MaterialSpec spec{{}, LobeSpec{"lambertian", {}}, std::move(lobes)};
  auto form = fit::make_form(spec, {});
  EXPECT_TRUE(form.ok());
  return *std::move(form);
}

TEST(SamePlace, LobesOfOneKindMayChangePlaces) {
  const auto form = form_of({ggx("none"), ggx("none"), ggx("none")});
  ASSERT_EQ(form.shapes.size(), 3U);
  const std::vector<double> a{0.02, 0.1, 0.6};
  for (const std::vector<double>& b :
       {a, std::vector{0.6, 0.02, 0.1}, {0.1, 0.6, 0.02}, {0.6, 0.1, 0.02}})
    EXPECT_FALSE(fit::apart(form, a, b).has_value());
}

TEST(SamePlace, ThatOfAnotherKindMayNot) {
  const auto form = form_of({ggx("none"), ggx("schlick")});
  const std::vector<double> a{0.02, 0.6}, b{0.6, 0.02};
  ASSERT_TRUE(fit::apart(form, a, b).has_value());
  EXPECT_EQ(fit::apart(form, a, b)->shape, 0U);
}

// Not that which has only changed its place.
TEST(SamePlace, WhatDiffersIsNamed) {
  const auto form = form_of({ggx("none"), ggx("none"), ggx("none")});
  const std::vector<double> a{0.02, 0.1, 0.6}, b{0.1, 0.02, 0.005};
  const auto found = fit::apart(form, a, b);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->shape, 2U);
  EXPECT_EQ(found->at, 0.6);
  EXPECT_EQ(found->other, 0.005);
}

}  // namespace
}  // namespace gonio::testing
