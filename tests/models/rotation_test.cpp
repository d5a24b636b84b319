// What turning a material's tangents means. That turned values, densities and samples are right is
// the harness's to say, whose cases include turned ones; here is what they are equal to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "gonio/measured/table.h"
#include "measured/synthetic_merl.h"
#include "models/oracle/cases.h"
#include "models/oracle/run.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;

MaterialSpec turned(MaterialSpec spec, std::optional<double> degrees) {
  spec.rotation = degrees;
  return spec;
}

// In each precision, on each instruction set.
template <class Check>
void for_all_kernels(const Check& check) {
  for (const Isa isa : supported_isas()) {
    SCOPED_TRACE(name_of(isa));
    check(float(), float(), isa);
    check(float(), double(), isa);
    check(double(), double(), isa);
  }
}

class Rotation : public ::testing::TestWithParam<std::string> {};

TEST_P(Rotation, OfZeroChangesNoBit) {
  for (const Case& c : cases_of(GetParam())) {
    for_all_kernels([&](auto in, auto out, Isa isa) {
      using Out = decltype(out);
      const auto pairs = some_hard_pairs<decltype(in)>(3, 333);
      const auto none = library_values<Out>(material_of(turned(c.spec, {})), pairs, isa);
      EXPECT_EQ(library_values<Out>(material_of(turned(c.spec, 0)), pairs, isa), none) << c.name;
    });
  }
}

// Models that are alike along all tangents.
TEST_P(Rotation, ChangesNoBitOfWhatHasNoTangents) {
  for (const Case& c : cases_of(GetParam())) {
    const Material plain = material_of(turned(c.spec, {}));
    if (plain.has_tangents()) continue;
    const auto pairs = some_hard_pairs<float>(4, 333);
    EXPECT_EQ(library_values<float>(material_of(turned(c.spec, 33)), pairs, best_isa()),
              library_values<float>(plain, pairs, best_isa()))
        << c.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Rotation, ::testing::ValuesIn(models_with_cases()),
                         [](const auto& model) { return model.param; });

// A quarter of a turn is exact: the parameters change places, up to the order of a sum's terms.
TEST(Rotation, ByAQuarterSwapsTheTangents) {
  struct Swapped {
    std::string model, u, v;
    double along_u, along_v;
  };
  for (const auto& [model, u, v, a, b] : {Swapped{"ggx", "alpha_x", "alpha_y", 0.02, 0.4},
                                          {"ward", "alpha_x", "alpha_y", 0.3, 0.05},
                                          {"ashikhmin_shirley", "nu", "nv", 1e5, 30}}) {
    const Material plain = material_of(alone(model, {{u, number(b)}, {v, number(a)}}));
    for (const double degrees : {90.0, -90.0}) {
      const Material quarter =
          material_of(turned(alone(model, {{u, number(a)}, {v, number(b)}}), degrees));
      for_all_kernels([&, &name = model](auto in, auto out, Isa isa) {
        using Out = decltype(out);
        const auto pairs = some_hard_pairs<decltype(in)>(5, 1000, 1e-5);
        const auto got = library_values<Out>(quarter, pairs, isa);
        const auto want = library_values<Out>(plain, pairs, isa);
        const double allowed =
            2 *
            quarter
                .error_bound(sizeof(Out) == sizeof(float) ? Precision::fast : Precision::reference)
                .relative;
        for (std::size_t i = 0; i < got.size(); ++i) {
          const auto f = static_cast<double>(want[i]);
          EXPECT_NEAR(static_cast<double>(got[i]), f, allowed * std::max(f, 1e-30)) << name;
        }
      });
    }
  }
}

TEST(Rotation, AddsUp) {
  const MaterialSpec brushed =
      alone("ggx", {{"alpha_x", number(0.1)}, {"alpha_y", number(0.5)}, {"f0", number(0.9)}});
  const auto pairs = some_hard_pairs<double>(6, 1000);
  const auto values = [&](const Material& m) {
    return library_values<double>(m, pairs, best_isa());
  };
  const Material by_170 = material_of(turned(brushed, 170));
  EXPECT_EQ(values(by_170.turned(30)), values(material_of(turned(brushed, -160))));
  EXPECT_EQ(values(by_170.turned(-170)), values(material_of(brushed)));
}

TEST(Rotation, OfATableIsTheTable) {
  const auto table = MeasuredTable::from_values(tabulate(glossy_example));
  ASSERT_TRUE(table.ok());
  const Material measured = Material::from_table(*table, Interpolation::linear);
  EXPECT_FALSE(measured.has_tangents());
  const auto pairs = some_hard_pairs<float>(7, 500);
  EXPECT_EQ(library_values<float>(measured.turned(30), pairs, best_isa()),
            library_values<float>(measured, pairs, best_isa()));
}

TEST(Rotation, OutOfBoundsIsRefusedByName) {
  const auto refused = [](double degrees, std::string_view prefix) {
    const auto made = Material::create(turned(alone("lambertian", {}), degrees), prefix);
    return made.ok() ? Error{} : made.error();
  };
  for (const double degrees : {-180.0, 180.0, 0.0, -0.0, 1e-300})
    EXPECT_EQ(refused(degrees, {}).field, "") << degrees;
  for (const double degrees : {180.001, -181.0, 1e300, std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()}) {
    const Error error = refused(degrees, "material.");
    EXPECT_EQ(error.code, ErrorCode::invalid_argument) << degrees;
    EXPECT_EQ(error.field, "material.rotation");
    EXPECT_THAT(error.message, HasSubstr("[-180, 180]"));
  }
}

}  // namespace
}  // namespace gonio::testing
