// Optima beyond every bound of every model: a fit ends as well as anything inside.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "effort.h"
#include "fit/bounds/numbers.h"
#include "fit/registry_cases.h"
#include "fit/synthetic.h"

namespace gonio::testing {
namespace {

bool has_base_colour(const ModelDescription& model) {
  return std::any_of(model.parameters.begin(), model.parameters.end(), [&](const Parameter& p) {
    return quantity_of(p, model.role) == Quantity::base;
  });
}

std::vector<MaterialSpec> forms_of(const ModelDescription& model) {
  std::vector<MaterialSpec> forms;
  for (const LobeSpec& lobe : lobes_of(model)) {
    if (has_base_colour(model)) forms.push_back({lobe, {}, {}});
    if (model.role == Role::specular) forms.push_back({{}, LobeSpec{"lambertian", {}}, {lobe}});
  }
  return forms;
}

std::string name_of(const MaterialSpec& form, const Number& number, bool upper) {
  const LobeSpec& lobe = form.model ? *form.model : form.specular.front();
  std::string name = (form.model ? "" : "base + ") + lobe.model;
  for (const auto& [key, value] : lobe.parameters) name += ":" + std::get<std::string>(value);
  return name + " " + number.names.front() + (upper ? " above" : " below");
}

// What lies as far beyond a bound as `inside` before it, or a part of that: f goes on as a line.
fit::Data beyond(const MaterialSpec& bound, const MaterialSpec& inside, const Pairs& at) {
  constexpr double kPart = 0.3;
  fit::Data data = data_of(bound, at);
  const fit::Data other = data_of(inside, at);
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    const double f = static_cast<double>(data.values[i]), g = static_cast<double>(other.values[i]);
    data.values[i] = static_cast<float>(std::max(0.0, f + kPart * (f - g)));
  }
  return data;
}

double value_inside(const Number& number, bool upper) {
  const double bound = upper ? number.upper : number.lower;
  return number.stepped(bound, upper ? -0.5 : 0.5);
}

// L1's smoothing and the tolerances leave a part of the mean in two thousand.
constexpr double kAllowance = 5e-4;

class Planted {
 public:
  explicit Planted(unsigned seed) : at_(scattered_pairs(200, seed, 1e-5)) {}

  // A fit of what is planted beyond one bound, against the search from that bound.
  void expect_good(const MaterialSpec& form, const std::vector<Number>& numbers,
                   const MaterialSpec& ordinary, const Number& number, bool upper) {
    const std::string name = name_of(form, number, upper);
    const MaterialSpec bound = with(ordinary, number, upper ? number.upper : number.lower);
    const fit::Data data = beyond(bound, with(ordinary, number, value_inside(number, upper)), at_);
    const auto result = fit::fit(data, form, {});
    ASSERT_TRUE(result.ok()) << name << ": " << result.error().message;
    ASSERT_TRUE(Material::create(result->material).ok()) << name;
    EXPECT_LE(result->certificate.errors.all.l1, 1.01 * searched(bound, numbers, data) + kAllowance)
        << name << ": " << result->certificate.reason;
    held_ += result->certificate.active_bounds.empty() ? 0 : 1;
    ++trials_;
  }
  [[nodiscard]] int trials() const { return trials_; }
  [[nodiscard]] int held() const { return held_; }

 private:
  Pairs at_;
  int trials_ = 0, held_ = 0;
};

class EveryModel : public ::testing::TestWithParam<std::string> {};

MaterialSpec ordinary_of(MaterialSpec spec, const std::vector<Number>& numbers) {
  for (const Number& number : numbers) spec = with(spec, number, number.start);
  return spec;
}

TEST_P(EveryModel, EndsAsWellAsAnythingInsideItsBounds) {
  Planted planted(1);
  const ModelDescription& model = **find_model(GetParam());
  for (const MaterialSpec& spec : forms_of(model)) {
    const auto form = fit::make_form(spec, {});
    ASSERT_TRUE(form.ok());
    const auto numbers = numbers_of(*form);
    const MaterialSpec ordinary = ordinary_of(spec, numbers);
    for (const Number& number : numbers) {
      if (spec.diffuse && number.lobe == 0) continue;  // the base has cases of its own
      for (const bool upper : {false, true})
        planted.expect_good(spec, numbers, ordinary, number, upper);
    }
  }
  EXPECT_GE(planted.trials(), 2);
  EXPECT_GE(planted.held(), planted.trials() / 4);
}

// Without an exponent a lobe is its Fresnel factor alone, and a conductor's index has a basin on
// either side of 1, whatever the pairs.
TEST(HeldShapes, LetTheOthersBeFound) {
  const MaterialSpec spec{{},
                          LobeSpec{"lambertian", {}},
                          {LobeSpec{"phong_mix", {{"fresnel", std::string("conductor")}}}}};
  const auto form = fit::make_form(spec, {});
  ASSERT_TRUE(form.ok());
  const auto numbers = numbers_of(*form);
  const auto exponent = std::find_if(numbers.begin(), numbers.end(), [](const Number& number) {
    return number.names.front() == "s";
  });
  ASSERT_NE(exponent, numbers.end());
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    SCOPED_TRACE(seed);
    Planted(seed).expect_good(spec, numbers, ordinary_of(spec, numbers), *exponent, false);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const ModelDescription& model : models()) {
    if (model.role != Role::measured) all.emplace_back(model.name);
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Bounds, EveryModel, ::testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace gonio::testing
