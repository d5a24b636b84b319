// The product's truth, the models' templates in long double, against the independent 128-bit
// oracle: thousands of hard pairs for every case of every model.
#include "engine/truth/truth.h"

#include <gtest/gtest.h>

#include "gonio/measured/table.h"
#include "models/harness/compare.h"
#include "models/oracle/cases.h"
#include "models/oracle/run.h"
#include "models/oracle/truth.h"

namespace gonio::testing {
namespace {

// A five-hundredth of the tightest bound of a lobe in float64.
constexpr double kBound = 5e-14;

template <class In>
std::vector<Quad> product_truth(const Truth& truth, const std::vector<DirectionPair<In>>& pairs) {
  const auto channels = static_cast<std::size_t>(truth.channels());
  std::vector<Quad> values;
  std::vector<long double> f(channels);
  const auto wide = [](const std::array<In, 3>& w) { return Truth::Direction{w[0], w[1], w[2]}; };
  for (const auto& pair : pairs) {
    truth.evaluate(wide(pair.wi), wide(pair.wo), f);
    values.insert(values.end(), f.begin(), f.end());
  }
  return values;
}

class TruthOf : public ::testing::TestWithParam<std::string> {
 protected:
  template <class In>
  void hold(const Case& c, std::uint64_t seed) {
    const auto pairs = some_hard_pairs<In>(seed, 1500);
    const std::vector<Quad> oracle = truth_of(c.spec, pairs);
    const auto unsure = unsure_of(c.spec, Precision::reference, pairs, oracle);
    const std::vector<Quad> truth = product_truth(Truth(material_of(c.spec)), pairs);
    ASSERT_EQ(truth.size(), oracle.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ASSERT_TRUE(truth[i] >= 0) << c.name;
      if (!(oracle[i] > kAbove)) {
        ASSERT_TRUE(!(oracle[i] <= kAbove) || truth[i] <= 1.001 * kAbove) << c.name;
        continue;
      }
      if (oracle[i] > std::numeric_limits<double>::max()) continue;
      const Quad off = truth[i] - oracle[i];
      const auto error = static_cast<double>((off < 0 ? -off : off) / oracle[i]) -
                         (unsure.empty() ? 0 : unsure[i]);
      worst_ = std::max(worst_, error);
      EXPECT_LE(error, kBound) << c.name << ": " << text(truth[i]) << ", not " << text(oracle[i]);
    }
  }
  double worst_ = 0;
};

TEST_P(TruthOf, IsTheOracles) {
  std::uint64_t seed = 900;
  for (const Case& c : cases_of(GetParam())) {
    hold<float>(c, ++seed);
    hold<double>(c, ++seed);
  }
  std::cout << GetParam() << " worst " << worst_ << "\n";
}

INSTANTIATE_TEST_SUITE_P(Models, TruthOf, ::testing::ValuesIn(models_with_cases()),
                         [](const auto& model) { return model.param; });

TEST(Truth, ScaleIsTheValueAndBadPairsAreDark) {
  const Truth truth(material_of(alone("ggx", {{"alpha_x", number(0.3)}})));
  long double f = -1, scale = -1;
  truth.evaluate({0, 0, 1}, {0.6, 0, 0.8}, {&f, 1}, {&scale, 1});
  EXPECT_GT(f, 0);
  EXPECT_EQ(scale, f);
  for (const Truth::Direction& wo :
       {Truth::Direction{0, 0, -1}, {1, 0, 0}, {0, 0, 1.01}, {0, 0, std::nan("")}}) {
    truth.evaluate({0, 0, 1}, wo, {&f, 1}, {&scale, 1});
    EXPECT_EQ(f, 0);
    EXPECT_EQ(scale, 0);
  }
}

TEST(Truth, RoundingsAreThoseOfADifferenceOnly) {
  EXPECT_TRUE(Truth::of_roundings(material_of(alone("ggx", {})), 1e-12).empty());
  const auto moved = Truth::of_roundings(
      material_of(alone("oren_nayar", {{"rd", number(0.5)}, {"sigma", number(0.3)}})), 1e-3);
  ASSERT_EQ(moved.size(), 4U);  // both parameters, both ways
  long double f = 0;
  moved[0].evaluate({0, 0, 1}, {0, 0, 1}, {&f, 1});
  long double g = 0;
  moved[1].evaluate({0, 0, 1}, {0, 0, 1}, {&g, 1});
  EXPECT_NEAR(static_cast<double>(g / f), 1.002, 1e-4);
}

// Of a table errors are relative to the largest cell that is interpolated.
TEST(Truth, OfATable) {
  std::vector<float> cells(MeasuredTable::kCells * MeasuredTable::kChannels);
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i] = 0.1F + 0.01F * static_cast<float>(i / 3 % 180);
  const auto table = MeasuredTable::from_values(cells);
  ASSERT_TRUE(table.ok());
  const auto pairs = some_hard_pairs<double>(7, 4000, 1e-3);
  for (const auto kind : {Interpolation::linear, Interpolation::nearest}) {
    const Material material = Material::from_table(*table, kind);
    const Truth truth(material);
    const auto got = library_values<double>(material, pairs, best_isa());
    std::vector<long double> f(3), scale(3);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      truth.evaluate(pairs[i].wi, pairs[i].wo, f, scale);
      if (std::isnan(scale[0])) continue;  // which cell is a matter of rounding
      EXPECT_LE(f[0], scale[0] * (1 + 1e-15L));
      EXPECT_LE(std::abs(static_cast<long double>(got[3 * i]) - f[0]), 1e-10L * scale[0]);
      ++compared;
    }
    EXPECT_GT(compared, 2500U);
  }
}

}  // namespace
}  // namespace gonio::testing
