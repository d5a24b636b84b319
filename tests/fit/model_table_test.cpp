// What a fit makes of a model's table, whatever its names are: models by hand, none of the
// registry.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "fit/form.h"

namespace gonio::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr Parameter kW{.name = "w",
                       .meaning = {},
                       .unit = {},
                       .upper = 1,
                       .start = 0.4,
                       .type = ParameterType::colour};
constexpr Parameter kQ{.name = "q",
                       .meaning = {},
                       .unit = {},
                       .lower = 0.05,
                       .upper = 1,
                       .start = 0.3,
                       .scale = Scale::logarithmic};
constexpr Parameter kStrength{.name = "strength",
                              .meaning = {},
                              .unit = {},
                              .upper = 1e3,
                              .start = 1,
                              .type = ParameterType::colour,
                              .quantity = Quantity::amplitude};
constexpr Parameter kSchlick{.name = "r",
                             .meaning = {},
                             .unit = {},
                             .upper = 1,
                             .start = 0.2,
                             .type = ParameterType::colour,
                             .dependence = Dependence::affine};

// A lobe of a model with this table, as make_form gets it from the check of a material. Models live
// as long as the program, as those of the registry do: forms point to them.
class ByHand {
 public:
  ByHand(Role role, const std::vector<Parameter>& parameters, std::string prefix = "")
      : made_(kept().emplace_back(std::make_unique<Made>(Made{parameters, {}})).get()),
        prefix_(std::move(prefix)) {
    made_->model.name = spec_.model = "toy";
    made_->model.role = role;
    made_->model.parameters = made_->parameters;
    lobe_.model = &made_->model;
    for (const Parameter& p : made_->parameters) {
      if (p.type != ParameterType::word) lobe_.values.set(p.name, {p.start});
    }
  }
  void give(const std::string& name, double value) {
    spec_.parameters[name] = std::vector{value};
    lobe_.values.set(name, {value});
  }
  void tie(std::string_view u, std::string_view v) { made_->model.along_tangents = {u, v}; }
  void take_word(std::size_t kind) { lobe_.kind = kind; }

  [[nodiscard]] Result<fit::Form> form(const fit::FormOptions& options = {}) const {
    const NamedLobe named{&spec_, prefix_, {}};
    return fit::make_form(fit::CheckedLobes{{&named, 1}, {&lobe_, 1}}, {}, options);
  }
  [[nodiscard]] Error error() const {
    const auto made = form();
    EXPECT_FALSE(made.ok());
    return made ? Error{} : made.error();
  }

 private:
  struct Made {
    std::vector<Parameter> parameters;
    ModelDescription model;
  };
  static std::vector<std::unique_ptr<Made>>& kept() {
    static std::vector<std::unique_ptr<Made>> all;
    return all;
  }
  Made* made_;
  std::string prefix_;
  LobeSpec spec_;
  CheckedLobe lobe_{};
};

TEST(ModelTable, AColourIsSolvedForAndANumberSearched) {
  for (const Role role : {Role::diffuse, Role::specular}) {
    const auto form = ByHand(role, {kW, kQ}).form();
    ASSERT_TRUE(form.ok()) << form.error().message;
    EXPECT_EQ(form->coefficients, 1U);
    EXPECT_EQ(form->columns, 1U);
    ASSERT_EQ(form->shapes.size(), 1U);
    EXPECT_EQ(form->shapes[0].field, "parameters.q");
    EXPECT_TRUE(fit::is_width(form->shapes[0]));
    EXPECT_EQ(form->shapes[0].scan_lower, 0.05);
    const fit::LobeColours& colours = form->lobes[0].colours;
    EXPECT_EQ(fit::is_diffuse(colours.columns), role == Role::diffuse);
    EXPECT_EQ(colours.parameter(colours.members()[0]).name, "w");
    const LobeSpec column = fit::column_lobe(*form, 0, std::vector{std::log(0.2)});
    EXPECT_THAT(std::get<std::vector<double>>(column.parameters.at("w")), ElementsAre(1));
    EXPECT_NEAR(std::get<std::vector<double>>(column.parameters.at("q"))[0], 0.2, 1e-15);
  }
}

TEST(ModelTable, AGuessIsTaken) {
  ByHand toy(Role::specular, {kW, kQ});
  toy.give("q", 0.7);
  toy.give("w", 0.1);
  EXPECT_EQ(toy.form()->shapes[0].guess, 0.7);
}

// The product of an amplitude and a reflectance is told, and no more.
TEST(ModelTable, TwoColoursThatMultiplyAreOneCoefficient) {
  const auto form = ByHand(Role::specular, {kW, kQ, kStrength}).form();
  ASSERT_TRUE(form.ok()) << form.error().message;
  EXPECT_EQ(form->coefficients, 1U);
  EXPECT_EQ(form->lobes[0].colours.scale->name, "strength");
  EXPECT_EQ(form->lobes[0].colours.reflectance->name, "w");
  EXPECT_EQ(form->bounds_of(form->lobes[0]).upper.scale, 1e3);
}

TEST(ModelTable, AnAffineReflectanceHasTwoColumns) {
  const auto form = ByHand(Role::specular, {kSchlick, kStrength, kQ}).form();
  ASSERT_TRUE(form.ok()) << form.error().message;
  EXPECT_EQ(form->columns, 2U);
  const LobeSpec column = fit::column_lobe(*form, 0, std::vector{std::log(0.2)});
  EXPECT_THAT(std::get<std::vector<double>>(column.parameters.at("r")), ElementsAre(1, 0));
}

TEST(ModelTable, ABaseColourThatTheReflectanceDimsIsALobesOwnDiffuseTerm) {
  Parameter base = kW;
  base.quantity = Quantity::base;
  base.dimmed_by = "r";
  const auto alone = ByHand(Role::specular, {base, kSchlick, kStrength}).form();
  ASSERT_TRUE(alone.ok()) << alone.error().message;
  EXPECT_EQ(alone->coefficients, 3U);
  // In a sum it is held at 0: the base is another lobe's.
  const auto summed = ByHand(Role::specular, {base, kSchlick, kStrength}, "specular[0].").form();
  ASSERT_TRUE(summed.ok()) << summed.error().message;
  EXPECT_EQ(summed->coefficients, 2U);
  EXPECT_THAT(std::get<std::vector<double>>(summed->lobes[0].held.parameters.at("w")),
              ElementsAre(0));
}

TEST(ModelTable, ADependenceHoldsWithItsWords) {
  static constexpr std::array<std::string_view, 2> kWords{"square", "line"};
  static constexpr std::array<std::string_view, 1> kSquare{"square"};
  Parameter w = kW;
  w.dependence = Dependence::quadratic;
  w.dependence_with = {"kind", kSquare};
  ByHand toy(Role::diffuse, {w, Parameter{.name = "kind",
                                          .meaning = {},
                                          .unit = {},
                                          .type = ParameterType::word,
                                          .words = kWords}});
  EXPECT_EQ(toy.form()->lobes[0].colours.columns, fit::Columns::quadratic_diffuse);
  toy.take_word(1);
  EXPECT_EQ(toy.form()->lobes[0].colours.columns, fit::Columns::diffuse);
  EXPECT_EQ(std::get<std::string>(toy.form()->lobes[0].held.parameters.at("kind")), "line");
}

TEST(ModelTable, AColourThatMayNotBeOneIsEvaluatedWhereItMay) {
  Parameter w = kW;
  w.upper = 0.5;
  const auto form = ByHand(Role::diffuse, {w}).form();
  ASSERT_TRUE(form.ok()) << form.error().message;
  EXPECT_EQ(form->lobes[0].evaluated_at, 0.5);
  const LobeSpec column = fit::column_lobe(*form, 0, {});
  EXPECT_THAT(std::get<std::vector<double>>(column.parameters.at("w")), ElementsAre(0.5));
}

TEST(ModelTable, WhatReflectanceDoesNotTellIsHeld) {
  Parameter q = kQ;
  q.fitted = false;
  ByHand toy(Role::specular, {kW, q});
  EXPECT_TRUE(toy.form()->shapes.empty());
  toy.give("q", 0.6);
  EXPECT_THAT(std::get<std::vector<double>>(toy.form()->lobes[0].held.parameters.at("q")),
              ElementsAre(0.6));
}

TEST(ModelTable, WhatBelongsToTheTangentsIsTiedUnlessAnisotropic) {
  Parameter other = kQ;
  other.name = "p";
  ByHand toy(Role::specular, {kW, kQ, other});
  EXPECT_EQ(toy.form()->shapes.size(), 2U);
  toy.tie("q", "p");
  EXPECT_THAT(toy.form()->shapes[0].names, ElementsAre("q", "p"));
  EXPECT_EQ(toy.form({true})->shapes.size(), 2U);
  EXPECT_EQ(toy.form({true, true})->shapes.size(), 3U);
}

// A dielectric's index is above 1; beside an extinction it may be below. Names mean nothing.
TEST(ModelTable, AnIndexIsThatOfADielectricWithoutExtinction) {
  Parameter index = kQ, extinction = kQ;
  index.lower = 0.1, index.upper = 10, index.start = 1.5;
  index.quantity = Quantity::refractive_index;
  extinction.name = "x";
  extinction.quantity = Quantity::extinction;
  const auto dielectric = ByHand(Role::specular, {kW, index}).form();
  EXPECT_GT(dielectric->shapes[0].lower, 1);
  EXPECT_FALSE(fit::is_width(dielectric->shapes[0]));
  const auto metal = ByHand(Role::specular, {kW, index, extinction}).form();
  EXPECT_EQ(metal->shapes[0].lower, 0.1);
  Parameter eta = kQ;
  eta.name = "eta";
  EXPECT_EQ(ByHand(Role::specular, {kW, eta}).form()->shapes[0].lower, 0.05);
}

TEST(ModelTable, WhatCannotBeFittedIsRefusedByItsField) {
  Parameter second = kW, base = kW, affine_alone = kSchlick, signed_colour = kW;
  second.name = "v";
  base.name = "d", base.quantity = Quantity::base;
  signed_colour.lower = -1;
  const auto two = ByHand(Role::specular, {kW, second}, "specular[1].").error();
  EXPECT_EQ(two.code, ErrorCode::invalid_argument);
  EXPECT_EQ(two.field, "specular[1].parameters.v");
  EXPECT_THAT(two.value, HasSubstr("beside w"));
  EXPECT_THAT(two.allowed, HasSubstr("one reflectance"));
  EXPECT_EQ(ByHand(Role::specular, {kW, base}).error().field, "parameters.d");
  EXPECT_EQ(ByHand(Role::specular, {affine_alone, kQ}).error().field, "parameters.r");
  EXPECT_EQ(ByHand(Role::specular, {signed_colour}).error().field, "parameters.w");
  EXPECT_THAT(ByHand(Role::specular, {signed_colour}).error().value, HasSubstr("-1"));
  const auto none = ByHand(Role::specular, {kQ}).error();
  EXPECT_EQ(none.field, "model");
  EXPECT_EQ(none.value, "\"toy\"");
  EXPECT_FALSE(none.allowed.empty());
}

}  // namespace
}  // namespace gonio::testing
