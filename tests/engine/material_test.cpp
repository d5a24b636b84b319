// Specifications as a person writes them: what is taken, what is refused and how that is said.
#include "gonio/engine/material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/one_value.h"
#include "gonio/engine/evaluate.h"

namespace gonio {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Colour = std::vector<double>;

LobeSpec lobe(std::string model, decltype(LobeSpec::parameters) parameters = {}) {
  return {std::move(model), std::move(parameters)};
}

Error error_of(const MaterialSpec& spec, std::string_view prefix = {}) {
  const auto material = Material::create(spec, prefix);
  EXPECT_FALSE(material.ok());
  return material.ok() ? Error{} : material.error();
}

TEST(Material, IsOneModelOrASumAndNothingElse) {
  const Error empty = error_of({});
  EXPECT_EQ(empty.code, ErrorCode::invalid_argument);
  EXPECT_THAT(empty.message, AllOf(HasSubstr("empty"), HasSubstr("one model, or a sum")));
  EXPECT_THAT(error_of({lobe("ggx"), lobe("lambertian"), {}}).message,
              HasSubstr("a model and a sum"));
  EXPECT_THAT(error_of({lobe("ggx"), {}, {lobe("ggx")}}).message, HasSubstr("a model and a sum"));
  EXPECT_TRUE(Material::create({{}, lobe("lambertian"), {}}).ok());
  EXPECT_TRUE(Material::create({{}, {}, {lobe("ggx")}}).ok());
}

TEST(Material, HasAtMostFourLobes) {
  const std::vector<LobeSpec> four(kMaxSpecularLobes, lobe("ggx"));
  EXPECT_TRUE(Material::create({{}, lobe("lambertian"), four}).ok());
  std::vector<LobeSpec> five = four;
  five.push_back(lobe("ggx"));
  const Error error = error_of({{}, {}, five});
  EXPECT_EQ(error.field, "specular");
  EXPECT_THAT(error.message, AllOf(HasSubstr("5 lobes"), HasSubstr("at most 4")));
}

TEST(Material, WantsEachPartInItsPlace) {
  const Error base = error_of({{}, lobe("ggx"), {}});
  EXPECT_EQ(base.field, "diffuse.model");
  EXPECT_THAT(base.message, AllOf(HasSubstr("ggx"), HasSubstr("diffuse")));
  const Error part = error_of({{}, {}, {lobe("ggx"), lobe("lambertian")}});
  EXPECT_EQ(part.field, "specular[1].model");
  EXPECT_THAT(part.message, AllOf(HasSubstr("lambertian"), HasSubstr("specular")));
  const Error measured = error_of({lobe("measured"), {}, {}});
  EXPECT_EQ(measured.field, "model");
}

TEST(Material, NamesTheFieldWithItsPrefix) {
  const LobeSpec wrong = lobe("ggx", {{"alpha_x", Colour{2}}});
  const Error error = error_of({{}, lobe("lambertian"), {lobe("ggx"), wrong}}, "material.");
  EXPECT_EQ(error.field, "material.specular[1].parameters.alpha_x");
  EXPECT_EQ(error.value, "2");
  EXPECT_EQ(error.allowed, "[0.001, 1]");
  EXPECT_EQ(error.message, "material.specular[1].parameters.alpha_x is 2; allowed: [0.001, 1]");
  EXPECT_THAT(error_of({lobe("gxx"), {}, {}}, "material.").field, "material.model");
  EXPECT_THAT(error_of({}, "material.").field, "material");
}

TEST(Material, NamesTheChannelThatIsWrong) {
  const Error error = error_of({lobe("ggx", {{"f0", Colour{0.5, 0.5, -0.1}}}), {}, {}});
  EXPECT_EQ(error.field, "parameters.f0[2]");
  EXPECT_EQ(error.value, "-0.1");
}

TEST(Material, WantsChannelsToAgreeAcrossParts) {
  const LobeSpec rgb = lobe("lambertian", {{"rd", Colour{0.1, 0.2, 0.3}}});
  const LobeSpec four = lobe("ggx", {{"f0", Colour{0.1, 0.2, 0.3, 0.4}}});
  const Error error = error_of({{}, rgb, {lobe("ggx"), four}});
  EXPECT_EQ(error.field, "specular[1].parameters.f0");
  EXPECT_THAT(error.message, AllOf(HasSubstr("4 numbers"), HasSubstr("1 or 3"),
                                   HasSubstr("diffuse.parameters.rd")));
}

TEST(Material, SpreadsOneNumberOverAllChannels) {
  const auto f = value({{}, lobe("lambertian", {{"rd", Colour{0.1, 0.2, 0.3}}}), {lobe("ggx")}});
  const auto specular = value({lobe("ggx"), {}, {}});
  const double pi = std::numbers::pi;
  ASSERT_EQ(f.size(), 3U);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(f[c], 0.1 * static_cast<double>(c + 1) / pi + specular[0], 1e-14);
  }
}

TEST(Material, InfersFresnelFromWhatIsGiven) {
  const auto same = [](decltype(LobeSpec::parameters) given, const std::string& word) {
    const auto inferred = value({lobe("ggx", given), {}, {}});
    given["fresnel"] = word;
    return inferred == value({lobe("ggx", given), {}, {}});
  };
  EXPECT_TRUE(same({}, "none"));
  EXPECT_FALSE(same({{"eta", Colour{1.8}}}, "conductor"));
  EXPECT_TRUE(same({{"f0", Colour{0.3}}}, "schlick"));
  EXPECT_TRUE(same({{"eta", Colour{1.8}}}, "dielectric"));
  EXPECT_TRUE(same({{"eta", Colour{1.8}}, {"k", Colour{2}}}, "conductor"));
  EXPECT_TRUE(same({{"k", Colour{2}}}, "conductor"));
}

TEST(Material, RefusesNumbersThatItsFresnelWouldIgnore) {
  struct Wrong {
    std::string name, word;
  };
  for (const auto& [name, word] :
       {Wrong{"f0", "none"}, Wrong{"f0", "dielectric"}, Wrong{"k", "dielectric"},
        Wrong{"eta", "schlick"}, Wrong{"eta", "none"}, Wrong{"k", "schlick"}}) {
    const Error error = error_of({lobe("ggx", {{name, Colour{1}}, {"fresnel", word}}), {}, {}});
    EXPECT_EQ(error.field, "parameters." + name);
    EXPECT_THAT(error.message, HasSubstr(word));
  }
  EXPECT_EQ(error_of({lobe("ggx", {{"f0", Colour{0.5}}, {"eta", Colour{1.5}}}), {}, {}}).field,
            "parameters.eta");
}

TEST(Material, StatesTheWorstBoundOfItsParts) {
  const auto diffuse = Material::create({lobe("lambertian"), {}, {}});
  const auto specular = Material::create({lobe("ggx"), {}, {}});
  const auto sum = Material::create({{}, lobe("lambertian"), {lobe("ggx")}});
  for (const Precision p : {Precision::fast, Precision::reference}) {
    EXPECT_EQ(sum->error_bound(p).relative,
              std::max(diffuse->error_bound(p).relative, specular->error_bound(p).relative));
  }
  EXPECT_GT(sum->bytes(), diffuse->bytes());
}

}  // namespace
}  // namespace gonio
