// Evaluation of measured tables against an independent lookup, and what interpolation must keep.
#include "measured/lookup.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

#include "engine/batches.h"
#include "gonio/engine/registry.h"
#include "measured/npf_material.h"
#include "measured/synthetic_merl.h"

namespace gonio::testing {
namespace {

using TablePtr = std::shared_ptr<const MeasuredTable>;
constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();

TablePtr table_of(const std::vector<float>& values) {
  return MeasuredTable::from_values(values).value();
}

// No two cells alike, so that a wrong one shows; a part of the cells is invalid.
TablePtr random_table(double invalid) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(0.5F, 2);
  std::vector<float> values(kMerlCells * 3);
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const bool bad = std::uniform_real_distribution<double>(0, 1)(random) < invalid;
    for (std::size_t c = 0; c < 3; ++c) values[i + c] = bad ? kInvalid : value(random);
  }
  return table_of(values);
}

template <class In, class Out>
struct Evaluated {
  std::vector<Out> values;
  std::vector<std::uint8_t> flags;
};

template <class Out, class In>
Evaluated<In, Out> run(const TablePtr& table, Interpolation interpolation, const Pairs<In>& pairs,
                       Isa isa) {
  Evaluated<In, Out> r{std::vector<Out>(pairs.size() * 3, Out(-1)),
                       std::vector<std::uint8_t>(pairs.size(), 255)};
  evaluate(Material::from_table(table, interpolation),
           batch_of(pairs, 0, pairs.size(), r.values.data(), 3, r.flags.data()), isa);
  return r;
}

template <class In>
Position position_of(const Pairs<In>& pairs, std::size_t i) {
  const auto direction = [i](const std::vector<In>& w) {
    return Direction{w[3 * i], w[3 * i + 1], w[3 * i + 2]};
  };
  return position(rusinkiewicz(direction(pairs.wi), direction(pairs.wo)));
}

template <class T>
class Lookup : public ::testing::Test {
 protected:
  static constexpr bool kFast = sizeof(typename T::Out) == 4;
  // How well a position is known, in cells; and the stated bound of interpolation.
  static constexpr double kPosition = 1e-9;
  static double bound() {
    const ModelDescription& measured = **find_model("measured");
    return kFast ? measured.fast.relative : measured.reference.relative;
  }
};
using AllTypes = ::testing::Types<InOut<float, float>, InOut<float, double>, InOut<double, double>>;
TYPED_TEST_SUITE(Lookup, AllTypes);

TYPED_TEST(Lookup, NearestIsThatOfTheDatabasesReader) {
  using Out = typename TypeParam::Out;
  const TablePtr table = random_table(0.2);
  const auto pairs = random_pairs<typename TypeParam::In>(50000);
  for (const Isa isa : supported_isas()) {
    const auto got = run<Out>(table, Interpolation::nearest, pairs, isa);
    std::size_t compared = 0, outside = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Position at = position_of(pairs, i);
      if (distance_to_wall(at) < this->kPosition) continue;
      ++compared;
      const float* want = table->data() + 3 * nearest_cell(at);
      const bool valid = !std::isnan(want[0]);
      ASSERT_EQ(got.flags[i] & ~flag::hole, valid ? 0 : flag::outside_data) << i;
      outside += valid ? 0 : 1;
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(got.values[3 * i + c], valid ? static_cast<Out>(want[c]) : 0)
            << name_of(isa) << " " << i;
      }
    }
    EXPECT_GT(compared, pairs.size() * 99 / 100);
    EXPECT_GT(outside, pairs.size() / 10);
  }
}

TYPED_TEST(Lookup, LinearIsTrilinearBetweenValidCells) {
  using Out = typename TypeParam::Out;
  const auto pairs = random_pairs<typename TypeParam::In>(50000, 2);
  for (const double invalid : {0.0, 0.2, 0.9}) {
    const TablePtr table = random_table(invalid);
    for (const Isa isa : supported_isas()) {
      const auto got = run<Out>(table, Interpolation::linear, pairs, isa);
      std::size_t outside = 0;
      double worst = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Interpolated want = interpolate(*table, position_of(pairs, i));
        if (want.weight > 0 && want.weight < 1e-3L) continue;  // rounding decides
        ASSERT_EQ(got.flags[i] & ~flag::hole, want.weight > 0 ? 0 : flag::outside_data) << i;
        outside += want.weight > 0 ? 0 : 1;
        for (std::size_t c = 0; c < 3; ++c) {
          const auto error = std::abs(static_cast<Real>(got.values[3 * i + c]) - want.value[c]);
          // Where nothing is known the value is 0, exactly.
          worst = std::max(
              worst, static_cast<double>(want.weight > 0 ? error / want.largest : error * 1e30L));
        }
      }
      EXPECT_LE(worst, this->bound()) << name_of(isa) << ", invalid " << invalid;
      EXPECT_EQ(outside > 0, invalid > 0.5);
    }
  }
}

TYPED_TEST(Lookup, InvalidCellsDoNotBleed) {
  using Out = typename TypeParam::Out;
  std::mt19937 random(3);
  std::vector<float> values(kMerlCells * 3, 0.7F);
  for (std::size_t i = 0; i < kMerlCells; ++i) {
    if (random() % 2 == 0) values[3 * i + random() % 3] = random() % 2 == 0 ? kInvalid : -1;
  }
  const TablePtr table = table_of(values);
  const auto pairs = random_pairs<typename TypeParam::In>(50000, 4);
  for (const Isa isa : supported_isas()) {
    const auto got = run<Out>(table, Interpolation::linear, pairs, isa);
    std::size_t known = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if ((got.flags[i] & ~flag::hole) != 0) continue;
      ++known;
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_NEAR(static_cast<double>(got.values[3 * i + c]), static_cast<double>(0.7F),
                    this->kFast ? 3e-7 : 1e-14);
      }
    }
    EXPECT_GT(known, pairs.size() * 9 / 10);
  }
}

TYPED_TEST(Lookup, HasNothingToSayWhereNothingWasMeasured) {
  using Out = typename TypeParam::Out;
  const TablePtr table = table_of(std::vector<float>(kMerlCells * 3, -1));
  EXPECT_EQ(table->invalid_cells(), kMerlCells);
  const auto pairs = random_pairs<typename TypeParam::In>(100, 4);
  for (const Isa isa : supported_isas()) {
    for (const auto interpolation : {Interpolation::linear, Interpolation::nearest}) {
      const auto got = run<Out>(table, interpolation, pairs, isa);
      for (const Out v : got.values) ASSERT_EQ(v, 0);
      for (const std::uint8_t f : got.flags) ASSERT_EQ(f, flag::outside_data);
    }
  }
}

TYPED_TEST(Lookup, IsReciprocal) {
  using Out = typename TypeParam::Out;
  const TablePtr table = random_table(0.1);
  const auto there = random_pairs<typename TypeParam::In>(20000, 5);
  auto back = there;
  std::swap(back.wi, back.wo);
  for (const Isa isa : supported_isas()) {
    const auto a = run<Out>(table, Interpolation::linear, there, isa);
    const auto b = run<Out>(table, Interpolation::linear, back, isa);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      ASSERT_NEAR(static_cast<double>(a.values[i]), static_cast<double>(b.values[i]),
                  4 * this->bound())
          << i / 3;
    }
  }
}

TYPED_TEST(Lookup, ReproducesASmoothFunction) {
  using Out = typename TypeParam::Out;
  const IsotropicFunction smooth = [](double h, double d, double p) {
    return Rgb{1 + std::cos(h) * std::cos(d), 2 + std::sin(2 * p) * std::sin(d) * std::sin(h),
               std::cos(h / 2)};
  };
  const TablePtr table = table_of(tabulate(smooth));
  const auto pairs = random_pairs<typename TypeParam::In>(20000, 6);
  for (const Isa isa : supported_isas()) {
    const auto got = run<Out>(table, Interpolation::linear, pairs, isa);
    double worst = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Position at = position_of(pairs, i);
      // Half a cell from the ends of theta_d the nearest centre stands for what lies beyond it.
      if (at.d < 0.5L || at.d > 89.5L || at.h > 89.5L) continue;
      const auto u = static_cast<double>(at.h / 90);
      const Rgb want =
          smooth(u * u * std::numbers::pi / 2, static_cast<double>(at.d) * std::numbers::pi / 180,
                 static_cast<double>(at.p) * std::numbers::pi / 180);
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_TRUE(std::isfinite(got.values[3 * i + c]));
        worst = std::max(worst, std::abs(static_cast<double>(got.values[3 * i + c]) - want[c]));
      }
    }
    EXPECT_LE(worst, 5e-4) << name_of(isa);  // cells of a degree or two, squared, over eight
  }
}

TYPED_TEST(Lookup, ReadsHardPlacesWithoutHarm) {
  using In = typename TypeParam::In;
  using Out = typename TypeParam::Out;
  const TablePtr table = random_table(0);
  Pairs<In> pairs;
  const auto tiny = static_cast<In>(1e-30);
  const std::vector<std::array<In, 3>> directions{{0, 0, 1},
                                                  {In(0.6), 0, In(0.8)},
                                                  {In(-0.6), 0, In(0.8)},
                                                  {0, In(0.6), In(0.8)},
                                                  {0, In(-0.6), In(0.8)},
                                                  {1, 0, tiny},
                                                  {-1, 0, tiny},
                                                  {0, 1, tiny},
                                                  {0, -1, tiny},
                                                  {tiny, tiny, 1},
                                                  {-tiny, tiny, 1}};
  for (const auto& wi : directions) {
    for (const auto& wo : directions) {
      pairs.wi.insert(pairs.wi.end(), wi.begin(), wi.end());
      pairs.wo.insert(pairs.wo.end(), wo.begin(), wo.end());
    }
  }
  for (const Isa isa : supported_isas()) {
    for (const auto interpolation : {Interpolation::linear, Interpolation::nearest}) {
      const auto got = run<Out>(table, interpolation, pairs, isa);
      for (const std::uint8_t f : got.flags) EXPECT_EQ(f, 0);
      // All weights are at least 0 and sum to 1: no value leaves the range of the table's.
      for (const Out v : got.values) EXPECT_TRUE(v >= Out(0.4999) && v <= Out(2.0001)) << v;
    }
  }
}

TYPED_TEST(Lookup, AgreesOnRealMaterials) {
  using Out = typename TypeParam::Out;
  const auto pairs = random_pairs<typename TypeParam::In>(20000, 7);
  for (const char* name : {"nickel", "pink-felt"}) {
    const auto material = NpfMaterial::load(name);
    if (!material) GTEST_SKIP() << "no " << name << " in " << data_folder() / "merl";
    const TablePtr table = table_of(tabulate(*material));
    for (const Isa isa : supported_isas()) {
      const auto got = run<Out>(table, Interpolation::linear, pairs, isa);
      double worst = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Interpolated want = interpolate(*table, position_of(pairs, i));
        if (want.weight < 1e-3L) continue;
        ASSERT_EQ(got.flags[i] & ~flag::hole, 0);
        for (std::size_t c = 0; c < 3; ++c) {
          const auto error = std::abs(static_cast<Real>(got.values[3 * i + c]) - want.value[c]);
          ASSERT_TRUE(std::isfinite(got.values[3 * i + c]));
          worst = std::max(worst, static_cast<double>(error / want.largest));
        }
      }
      EXPECT_LE(worst, this->bound()) << name << " " << name_of(isa);
    }
  }
}

}  // namespace
}  // namespace gonio::testing
