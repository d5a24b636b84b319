// A pair's, a sample's, a grid point's bits are those that it has in a batch of any other size: the
// sizes at which loops that compilers unroll and vectorise have a rest, or nothing but one.
#include <gtest/gtest.h>

#include "engine/material/derivative.h"
#include "engine/samples.h"
#include "gonio/engine/grid.h"

namespace gonio::testing {
namespace {

constexpr std::size_t kSizes[] = {1, 2, 3, 5, 4001};

template <class Out>
struct Evaluated {
  std::vector<Out> values, pdf;
  std::vector<std::uint8_t> flags;

  Evaluated(std::size_t count, int channels)
      : values(count * static_cast<std::size_t>(channels)), pdf(count), flags(count) {}
};

template <class Out>
::testing::AssertionResult begins_with(const Evaluated<Out>& whole, const Evaluated<Out>& part) {
  const bool same = same_bits(whole.values.data(), part.values.data(), part.values.size()) &&
                    same_bits(whole.pdf.data(), part.pdf.data(), part.pdf.size()) &&
                    same_bits(whole.flags.data(), part.flags.data(), part.flags.size());
  return same ? ::testing::AssertionSuccess()
              : ::testing::AssertionFailure() << "of " << part.flags.size();
}

// The results of the first `size` pairs, for every size, from the first of kSizes pairs.
template <class Out, class Evaluate>
void expect_same(int channels, const Evaluate& evaluate) {
  const auto run = [&](std::size_t size) {
    Evaluated<Out> to(size, channels);
    evaluate(size, to);
    return to;
  };
  const Evaluated<Out> whole = run(kSizes[std::size(kSizes) - 1] + 7);
  for (const std::size_t size : kSizes) ASSERT_TRUE(begins_with(whole, run(size)));
}

template <class In, class Out>
void check_evaluations(const Sampler& sampler, Isa isa) {
  const auto pairs = random_pairs<In>(5000);
  const Material& material = sampler.material();
  const int channels = material.channels();
  expect_same<Out>(channels, [&](std::size_t size, Evaluated<Out>& to) {
    evaluate(material, batch_of(pairs, 0, size, to.values.data(), channels, to.flags.data()), isa);
  });
  expect_same<Out>(channels, [&](std::size_t size, Evaluated<Out>& to) {
    evaluate(sampler, batch_of(pairs, 0, size, to.values.data(), channels, to.flags.data()),
             to.pdf.data(), isa);
  });
}

TEST(Sizes, OfEvaluationsWithAndWithoutDensities) {
  for_all_samplers([](const Sampler& sampler, Isa isa) {
    check_evaluations<float, float>(sampler, isa);
    check_evaluations<float, double>(sampler, isa);
    check_evaluations<double, double>(sampler, isa);
  });
}

template <class T>
void check_samples(const Sampler& sampler, Isa isa) {
  Request<T> request{random_pairs<T>(4010).wi};
  request.numbers = {Sequence::random, 3};
  const auto whole = draw(sampler, request, isa);
  for (const std::size_t size : kSizes) {
    ASSERT_TRUE(same(whole, 0, draw(sampler, request, 0, size, isa)));
    ASSERT_TRUE(same(whole, 7, draw(sampler, request, 7, size, isa)));
  }
}

TEST(Sizes, OfSamples) {
  for_all_samplers([](const Sampler& sampler, Isa isa) {
    check_samples<float>(sampler, isa);
    check_samples<double>(sampler, isa);
  });
}

TEST(Sizes, OfDerivatives) {
  const MaterialSpec spec{LobeSpec{"ggx", {{"alpha_x", std::vector<double>{0.2}}}}, {}, {}};
  const auto pairs = random_pairs<double>(5000);
  for (const char* by : {"parameters.alpha_x", "parameters.f0"}) {
    const auto derivative = MaterialDerivative::create(spec, by);
    ASSERT_TRUE(derivative.ok()) << derivative.error().message;
    for (const Isa isa : supported_isas()) {
      expect_same<double>(derivative->channels(), [&](std::size_t size, Evaluated<double>& to) {
        derivative->evaluate(
            batch_of(pairs, 0, size, to.values.data(), derivative->channels(), to.flags.data()),
            isa);
      });
    }
  }
}

template <class T>
void check_grid(const Grid& grid) {
  const auto expanded = [&](std::size_t count) {
    std::pair<std::vector<T>, std::vector<T>> to{std::vector<T>(3 * count),
                                                 std::vector<T>(3 * count)};
    grid.expand(11, count, to.first.data(), to.second.data());
    return to;
  };
  const auto whole = expanded(4001);
  for (const std::size_t size : kSizes) {
    const auto part = expanded(size);
    ASSERT_TRUE(same_bits(whole.first.data(), part.first.data(), 3 * size)) << size;
    ASSERT_TRUE(same_bits(whole.second.data(), part.second.data(), 3 * size)) << size;
  }
}

TEST(Sizes, OfGrids) {
  std::vector<double> angles;
  for (int i = 0; i < 17; ++i) angles.push_back(0.09 * i);
  const auto spherical = Grid::spherical(angles, {0, 1}, angles, {0, 1, 2, 3, 4, 5, 6});
  const auto half_angle = Grid::half_angle(angles, angles, angles);
  ASSERT_TRUE(spherical.ok() && half_angle.ok());
  for (const Grid& grid : {*spherical, *half_angle}) {
    check_grid<float>(grid);
    check_grid<double>(grid);
  }
}

}  // namespace
}  // namespace gonio::testing
