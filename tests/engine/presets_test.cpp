// Names in the place of numbers: what they stand for, and what is said of one that is not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/one_value.h"
#include "gonio/engine/evaluate.h"
#include "gonio/engine/registry.h"

namespace gonio {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using Given = decltype(LobeSpec::parameters);

MaterialSpec spec(std::string_view model, Given given) {
  return {LobeSpec{std::string(model), std::move(given)}, {}, {}};
}

const Parameter* parameter(const ModelDescription& model, std::string_view name) {
  const auto found = std::find_if(model.parameters.begin(), model.parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  return found == model.parameters.end() ? nullptr : &*found;
}

const Preset* preset(const Parameter& p, std::string_view name) {
  const auto found = std::find_if(p.presets.begin(), p.presets.end(),
                                  [&](const Preset& candidate) { return candidate.name == name; });
  return found == p.presets.end() ? nullptr : &*found;
}

template <class Check>
void for_each_preset(const Check& check) {
  for (const ModelDescription& model : models()) {
    for (const Parameter& p : model.parameters) {
      for (const Preset& candidate : p.presets) {
        SCOPED_TRACE(std::string(model.name) + "." + std::string(p.name) + " " +
                     std::string(candidate.name));
        check(model, p, candidate);
      }
    }
  }
}

TEST(Presets, AreInsideTheirBoundsAndHaveASource) {
  std::set<std::string_view> having;
  for_each_preset([&](const ModelDescription&, const Parameter& p, const Preset& found) {
    having.insert(p.name);
    EXPECT_EQ(p.type, ParameterType::colour);
    EXPECT_EQ(preset(p, found.name), &found) << "stands there twice";
    EXPECT_THAT(std::string(found.name), MatchesRegex("[a-z]+"));
    EXPECT_THAT(std::string(found.source), MatchesRegex(".*(19|20)[0-9][0-9].*"));
    for (const double channel : found.rgb) {
      EXPECT_GE(channel, p.lower);
      EXPECT_LE(channel, p.upper);
    }
  });
  EXPECT_EQ(having, (std::set<std::string_view>{"eta", "f0", "k", "rs"}));
}

TEST(Presets, AreTheSameAsTheirNumbers) {
  for_each_preset([](const ModelDescription& model, const Parameter& p, const Preset& found) {
    Given words{{std::string(p.name), std::string(found.name)}};
    Given numbers{{std::string(p.name), std::vector<double>(found.rgb.begin(), found.rgb.end())}};
    if (!p.preset_partner.empty()) {
      const Parameter* partner = parameter(model, p.preset_partner);
      ASSERT_NE(partner, nullptr);
      const Preset* other = preset(*partner, found.name);
      ASSERT_NE(other, nullptr);
      EXPECT_EQ(other->source, found.source);
      words[std::string(partner->name)] = std::string(found.name);
      numbers[std::string(partner->name)] =
          std::vector<double>(other->rgb.begin(), other->rgb.end());
    }
    const auto f = value(spec(model.name, words));
    EXPECT_EQ(f.size(), 3U);
    EXPECT_EQ(f, value(spec(model.name, numbers)));
  });
}

TEST(Presets, AnUnknownNameIsToldWhichThereAre) {
  const auto error = [](const char* model, const char* name) {
    return Material::create(spec(model, {{name, "bronze"}})).error();
  };
  EXPECT_EQ(error("ggx", "f0").message,
            "parameters.f0 is \"bronze\"; allowed: a number in [0, 1], or one of water, plastic, "
            "glass, diamond, copper, aluminium");
  EXPECT_THAT(error("ggx", "eta").allowed,
              AllOf(HasSubstr("[0.01, 100]"), HasSubstr("gold, silver, copper")));
  // A parameter that has none says so by not speaking of them.
  EXPECT_EQ(error("ggx", "alpha_x").allowed, "a number in [0.001, 1]");
}

TEST(Presets, HalfAConductorIsRefused) {
  const auto error = Material::create(spec("ggx", {{"eta", "gold"}})).error();
  EXPECT_EQ(error.field, "parameters.k");
  EXPECT_EQ(error.message, "parameters.k is not given; allowed: \"gold\", as for eta, or numbers");
  EXPECT_EQ(Material::create(spec("ggx", {{"k", "gold"}})).error().field, "parameters.eta");
  EXPECT_TRUE(Material::create(spec("ggx", {{"eta", "gold"}, {"k", std::vector{2.0}}})).ok());
}

TEST(Presets, HaveThreeChannels) {
  const std::vector<double> four{0.1, 0.2, 0.3, 0.4};
  const LobeSpec copper{"ggx", {{"f0", "copper"}}};
  EXPECT_EQ(value({{}, {}, {copper}}).size(), 3U);
  const auto error =
      Material::create({{}, LobeSpec{"lambertian", {{"rd", four}}}, {copper}}).error();
  EXPECT_EQ(error.field, "specular[0].parameters.f0");
  EXPECT_THAT(error.message, AllOf(HasSubstr("3 numbers"), HasSubstr("1 or 4")));
}

// A slip in a table of indices would show as a reflectance that the metal does not have.
TEST(Presets, ConductorsReflectWhatTheyAreKnownFor) {
  const ModelDescription& ggx = **find_model("ggx");
  const auto reflectance = [&](std::string_view name, std::size_t channel) {
    const double n = preset(*parameter(ggx, "eta"), name)->rgb.at(channel);
    const double k = preset(*parameter(ggx, "k"), name)->rgb.at(channel);
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
  };
  struct Known {
    const char* name;
    std::array<double, 3> rgb;
  };
  // Means over a channel's band, as renderers use them; surfaces and methods differ by as much.
  for (const Known& known :
       {Known{"gold", {1.00, 0.78, 0.34}}, Known{"silver", {0.97, 0.96, 0.92}},
        Known{"copper", {0.95, 0.64, 0.54}}, Known{"aluminium", {0.91, 0.92, 0.92}},
        Known{"chromium", {0.55, 0.56, 0.55}}, Known{"iron", {0.56, 0.57, 0.58}},
        Known{"nickel", {0.66, 0.61, 0.53}}}) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(reflectance(known.name, c), known.rgb.at(c), 0.09) << known.name << " " << c;
    }
  }
}

}  // namespace
}  // namespace gonio
