// Bad pairs get the value 0 and the right flag, and their neighbours do not notice.
#include <gtest/gtest.h>

#include <limits>

#include "engine/batches.h"
#include "gonio/engine/thread_pool.h"

namespace gonio::testing {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct BadDirection {
  std::array<double, 3> w;
  int flags;  // with `below` for the direction's own flag of the horizon
};
constexpr int kBelow = 128;  // replaced by the incident or the outgoing flag

const std::vector<BadDirection>& bad_directions() {
  static const std::vector<BadDirection> all{{{kNan, 0, 1}, flag::not_finite},
                                             {{0, kNan, 1}, flag::not_finite},
                                             {{0, 0, kNan}, flag::not_finite},
                                             {{kNan, kNan, kNan}, flag::not_finite},
                                             {{kInfinity, 0, 1}, flag::not_finite},
                                             {{0, -kInfinity, 1}, flag::not_finite},
                                             {{0, 0, kInfinity}, flag::not_finite},
                                             {{0, 0, 0}, flag::zero},
                                             {{0, -0.0, 0}, flag::zero},
                                             {{0, 0, 1.0011}, flag::not_unit},
                                             {{0, 0, 0.9989}, flag::not_unit},
                                             {{0.8, 0, 0.7}, flag::not_unit},
                                             {{3e38, 3e38, 3e38}, flag::not_unit},
                                             {{1e-30, 1e-30, 1e-30}, flag::not_unit},
                                             {{1e-44, 0, 1e-44}, flag::not_unit},
                                             {{0, 0, -1}, kBelow},
                                             {{1, 0, 0}, kBelow},
                                             {{0.6, 0.8, -0.0}, kBelow},
                                             {{0.6, 0, -0.8}, kBelow},
                                             {{0.6, 0.8, -1e-30}, kBelow},
                                             {{0, 0, -2}, kBelow | flag::not_unit},
                                             {{2, 0, 0}, kBelow | flag::not_unit}};
  return all;
}

std::uint8_t flags_of(const BadDirection& bad, bool incident) {
  const int below = incident ? flag::incident_below_horizon : flag::outgoing_below_horizon;
  return static_cast<std::uint8_t>((bad.flags & kBelow) != 0 ? (bad.flags & ~kBelow) | below
                                                             : bad.flags);
}

template <class T>
class FlagsOf : public ::testing::Test {};
using AllTypes = ::testing::Types<InOut<float, float>, InOut<float, double>, InOut<double, double>>;
TYPED_TEST_SUITE(FlagsOf, AllTypes);

template <class In, class Out>
struct Result {
  std::vector<Out> values;
  std::vector<std::uint8_t> flags;
  std::uint8_t all = 0;
};

template <class Out, class In>
Result<In, Out> run(const Material& material, const Pairs<In>& pairs, Isa isa) {
  Result<In, Out> r{
      std::vector<Out>(pairs.size() * static_cast<std::size_t>(material.channels()), Out(-1)),
      std::vector<std::uint8_t>(pairs.size(), 255), 0};
  r.all = evaluate(
      material,
      batch_of(pairs, 0, pairs.size(), r.values.data(), material.channels(), r.flags.data()), isa);
  return r;
}

template <class In>
void put(std::vector<In>& directions, std::size_t i, const std::array<double, 3>& w) {
  for (std::size_t c = 0; c < 3; ++c) directions[3 * i + c] = static_cast<In>(w[c]);
}

TYPED_TEST(FlagsOf, EveryBadDirectionIsSaidToBeSo) {
  using In = typename TypeParam::In;
  using Out = typename TypeParam::Out;
  for (const NamedMaterial& m : all_kinds_of_material()) {
    for (const Isa isa : supported_isas()) {
      for (const BadDirection& bad : bad_directions()) {
        for (const bool incident : {true, false}) {
          Pairs<In> pairs = random_pairs<In>(1);
          put(incident ? pairs.wi : pairs.wo, 0, bad.w);
          const auto result = run<Out>(m.material, pairs, isa);
          for (const Out v : result.values)
            ASSERT_TRUE(same_bits(&v, std::array<Out, 1>{}.data(), 1)) << v;
          ASSERT_EQ(result.flags[0], flags_of(bad, incident))
              << m.name << " " << name_of(isa) << (incident ? " wi " : " wo ") << bad.w[0] << " "
              << bad.w[1] << " " << bad.w[2];
          ASSERT_EQ(result.all, result.flags[0]);
        }
      }
    }
  }
}

TYPED_TEST(FlagsOf, BothDirectionsAreTold) {
  using In = typename TypeParam::In;
  const Material material = all_kinds_of_material()[0].material;
  for (const BadDirection& bad_wi : bad_directions()) {
    for (const BadDirection& bad_wo : bad_directions()) {
      Pairs<In> pairs = random_pairs<In>(1);
      put(pairs.wi, 0, bad_wi.w);
      put(pairs.wo, 0, bad_wo.w);
      for (const Isa isa : supported_isas()) {
        EXPECT_EQ(run<typename TypeParam::Out>(material, pairs, isa).flags[0],
                  flags_of(bad_wi, true) | flags_of(bad_wo, false));
      }
    }
  }
}

TYPED_TEST(FlagsOf, DirectionsWithinOneInAThousandAreTaken) {
  using In = typename TypeParam::In;
  const Material material = all_kinds_of_material()[0].material;
  for (const double length : {0.99901, 0.9995, 1.0005, 1.00099}) {
    Pairs<In> pairs = random_pairs<In>(100);
    for (In& c : pairs.wi) c = static_cast<In>(static_cast<double>(c) * length);
    for (In& c : pairs.wo) c = static_cast<In>(static_cast<double>(c) / length);
    for (const Isa isa : supported_isas())
      EXPECT_EQ(run<typename TypeParam::Out>(material, pairs, isa).all, 0);
  }
}

TYPED_TEST(FlagsOf, NeighboursDoNotNotice) {
  using In = typename TypeParam::In;
  using Out = typename TypeParam::Out;
  const Pairs<In> good = random_pairs<In>(1500, 4);
  Pairs<In> mixed = good;
  std::vector<std::uint8_t> want_flags(good.size());
  std::uint8_t want_all = 0;
  std::mt19937 random(9);
  for (std::size_t i = 0; i < good.size(); ++i) {
    // Runs of bad ones, single ones, and stretches without.
    const bool is_bad = i < 20 || i >= good.size() - 3 || (i > 500 && random() % 5 == 0);
    if (!is_bad) continue;
    const BadDirection& bad = bad_directions()[random() % bad_directions().size()];
    const bool incident = random() % 2 == 0;
    put(incident ? mixed.wi : mixed.wo, i, bad.w);
    want_flags[i] = flags_of(bad, incident);
    want_all |= want_flags[i];
  }
  for (const NamedMaterial& m : all_kinds_of_material()) {
    for (const Isa isa : supported_isas()) {
      const auto clean = run<Out>(m.material, good, isa), result = run<Out>(m.material, mixed, isa);
      EXPECT_EQ(clean.all, 0);
      EXPECT_EQ(result.all, want_all);
      ASSERT_EQ(result.flags, want_flags) << m.name << " " << name_of(isa);
      const auto n = static_cast<std::size_t>(m.material.channels());
      const std::vector<Out> zeros(n);
      for (std::size_t i = 0; i < good.size(); ++i) {
        const Out* want = want_flags[i] != 0 ? zeros.data() : &clean.values[i * n];
        ASSERT_TRUE(same_bits(&result.values[i * n], want, n))
            << m.name << " " << name_of(isa) << " pair " << i;
      }
    }
  }
}

TYPED_TEST(FlagsOf, ThreadsGatherAllFlags) {
  using In = typename TypeParam::In;
  using Out = typename TypeParam::Out;
  Pairs<In> pairs = random_pairs<In>(30000, 5);
  put(pairs.wi, 17, {0, 0, 0});
  put(pairs.wo, 14000, {0, 0, -1});
  put(pairs.wi, 29999, {kNan, 0, 1});
  ThreadPool pool(3, 2);
  for (const NamedMaterial& m : all_kinds_of_material()) {
    const auto alone = run<Out>(m.material, pairs, best_isa());
    auto shared = alone;
    std::ranges::fill(shared.values, Out(-1));
    std::ranges::fill(shared.flags, std::uint8_t{255});
    const auto batch = batch_of(pairs, 0, pairs.size(), shared.values.data(), m.material.channels(),
                                shared.flags.data());
    EXPECT_EQ(evaluate(m.material, batch, best_isa(), pool),
              flag::zero | flag::outgoing_below_horizon | flag::not_finite);
    EXPECT_EQ(shared.flags, alone.flags);
    EXPECT_TRUE(same_bits(shared.values.data(), alone.values.data(), alone.values.size()));
  }
}

}  // namespace
}  // namespace gonio::testing
