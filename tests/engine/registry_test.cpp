// What the models say of themselves is true of the checks (tests/models has the rest).
#include "gonio/engine/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "gonio/engine/material.h"
#include "models/harness/analytic_models.h"

namespace gonio {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

TEST(Registry, HasTheModels) {
  std::set<std::string_view> names;
  for (const ModelDescription& model : models()) {
    EXPECT_TRUE(names.insert(model.name).second) << model.name << " stands there twice";
  }
  EXPECT_TRUE(names.contains("measured"));
  EXPECT_GT(names.size(), 4U);
}

TEST(Registry, FindsByNameOrSaysWhichThereAre) {
  for (const ModelDescription& model : models()) {
    const auto found = find_model(model.name);
    ASSERT_TRUE(found.ok());
    EXPECT_EQ(*found, &model);
  }
  for (const char* name : {"", "phong2", "GGX", "ggx "}) {
    const auto none = find_model(name);
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().code, ErrorCode::not_found);
    EXPECT_THAT(none.error().message, HasSubstr('"' + std::string(name) + '"'));
    EXPECT_THAT(none.error().allowed, AllOf(HasSubstr("ggx"), HasSubstr("lambertian")));
  }
}

class EachModel : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static const ModelDescription& model() { return **find_model(GetParam()); }
  static Result<Material> with(const std::string& name, ParameterValue value) {
    return Material::create({LobeSpec{GetParam(), {{name, std::move(value)}}}, {}, {}});
  }
};

TEST_P(EachModel, NeedsNoParameter) {
  const auto material = Material::create({LobeSpec{GetParam(), {}}, {}, {}});
  ASSERT_TRUE(material.ok()) << material.error().message;
  EXPECT_EQ(material->channels(), 1);
  EXPECT_EQ(material->error_bound(Precision::fast).relative, model().fast.relative);
  EXPECT_EQ(material->error_bound(Precision::reference).relative, model().reference.relative);
  EXPECT_GT(material->bytes(), 0U);
}

TEST_P(EachModel, AcceptsItsBoundsAndNothingBeyond) {
  for (const Parameter& p : model().parameters) {
    if (p.type == ParameterType::word) continue;
    const std::string name(p.name), field = "parameters." + name;
    for (const double inside : {p.lower, p.start, p.upper}) {
      const auto material = with(name, std::vector{inside});
      EXPECT_TRUE(material.ok()) << material.error().message;
    }
    const double infinity = HUGE_VAL;
    for (const double outside :
         {std::nextafter(p.lower, -infinity), std::nextafter(p.upper, infinity), -infinity,
          infinity, std::nan("")}) {
      const auto material = with(name, std::vector{outside});
      ASSERT_FALSE(material.ok()) << field << " = " << outside;
      EXPECT_EQ(material.error().code, ErrorCode::invalid_argument);
      EXPECT_EQ(material.error().field, field);
      EXPECT_THAT(material.error().message,
                  AllOf(HasSubstr(field), HasSubstr(material.error().value),
                        HasSubstr(material.error().allowed)));
      EXPECT_THAT(material.error().allowed, MatchesRegex("\\[.*, .*\\]"));
    }
  }
}

TEST_P(EachModel, AcceptsItsWordsAndNoOther) {
  for (const Parameter& p : model().parameters) {
    const std::string name(p.name);
    if (p.type != ParameterType::word) {
      EXPECT_FALSE(with(name, "word").ok()) << name;
      continue;
    }
    for (const std::string_view word : p.words) {
      const auto material = with(name, std::string(word));
      EXPECT_TRUE(material.ok()) << material.error().message;
    }
    for (const ParameterValue& wrong :
         {ParameterValue("other"), ParameterValue(""), ParameterValue(std::vector{1.0})}) {
      const auto material = with(name, wrong);
      ASSERT_FALSE(material.ok());
      EXPECT_EQ(material.error().field, "parameters." + name);
      EXPECT_THAT(material.error().allowed, HasSubstr(std::string(p.words[0])));
    }
  }
}

TEST_P(EachModel, TakesOneNumberAChannelForColoursOnly) {
  for (const Parameter& p : model().parameters) {
    if (p.type == ParameterType::word) continue;
    for (const std::size_t count :
         {std::size_t{0}, std::size_t{2}, std::size_t{64}, std::size_t{65}}) {
      const auto material = with(std::string(p.name), std::vector<double>(count, p.start));
      const bool allowed = p.type == ParameterType::colour && count >= 1 && count <= kMaxChannels;
      ASSERT_EQ(material.ok(), allowed) << p.name << " with " << count;
      if (allowed) {
        EXPECT_EQ(material->channels(), static_cast<int>(count));
      }
    }
  }
}

TEST_P(EachModel, RefusesParametersOfOthers) {
  const auto material = with("no_such", std::vector{1.0});
  ASSERT_FALSE(material.ok());
  EXPECT_EQ(material.error().field, "parameters.no_such");
  for (const Parameter& p : model().parameters) {
    EXPECT_THAT(material.error().allowed, HasSubstr(std::string(p.name)));
  }
}

// What a fit reads of a table makes sense.
TEST_P(EachModel, SaysOfColoursAloneThatTheyAreSome) {
  const auto& all = model().parameters;
  const auto named = [&](std::string_view name) {
    return std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name == name; });
  };
  for (const Parameter& p : all) {
    SCOPED_TRACE(p.name);
    const Quantity quantity = quantity_of(p, model().role);
    const bool shape = quantity == Quantity::shape || quantity == Quantity::refractive_index ||
                       quantity == Quantity::extinction;
    EXPECT_TRUE(shape || p.type == ParameterType::colour);
    EXPECT_TRUE(p.scale == Scale::linear || p.lower >= 0);
    EXPECT_TRUE(p.fit_word.empty() ||
                std::find(p.words.begin(), p.words.end(), p.fit_word) != p.words.end());
    if (p.dependence != Dependence::linear) {
      EXPECT_FALSE(shape);
      EXPECT_TRUE(p.lower <= 0 && p.upper >= 1);
    }
    if (!p.dependence_with.parameter.empty()) {
      ASSERT_NE(named(p.dependence_with.parameter), all.end());
      const auto& words = named(p.dependence_with.parameter)->words;
      for (const std::string_view word : p.dependence_with.words)
        EXPECT_NE(std::find(words.begin(), words.end(), word), words.end()) << word;
    }
    if (!p.dimmed_by.empty()) {
      EXPECT_EQ(quantity, Quantity::base);
      ASSERT_NE(named(p.dimmed_by), all.end());
      EXPECT_EQ(named(p.dimmed_by)->dependence, Dependence::affine);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EachModel, ::testing::ValuesIn(testing::analytic_models()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace gonio
