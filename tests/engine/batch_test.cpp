// A pair's value depends on the pair alone: not on the batch, its layout, or threads (bit for bit).
#include <gtest/gtest.h>

#include "engine/batches.h"
#include "engine/thread_pool.h"

namespace gonio::testing {
namespace {

template <class T>
class BatchOf : public ::testing::Test {
 protected:
  using Input = typename T::In;
  using Output = typename T::Out;

  void SetUp() override { materials_ = all_kinds_of_material(); }

  // Every pair evaluated by itself: what all others are compared with.
  static std::vector<Output> one_by_one(const Material& material, const Pairs<Input>& pairs,
                                        Isa isa) {
    const int channels = material.channels();
    std::vector<Output> values(pairs.size() * static_cast<std::size_t>(channels));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      Output* to = values.data() + i * static_cast<std::size_t>(channels);
      evaluate(material, batch_of(pairs, i, 1, to, channels, nullptr), isa);
    }
    return values;
  }

  template <class Body>
  void for_all(const Body& body) {
    for (const NamedMaterial& m : materials_) {
      for (const Isa isa : supported_isas()) {
        SCOPED_TRACE(m.name + ", " + std::string(name_of(isa)));
        body(m.material, isa);
        if (this->HasFatalFailure()) return;
      }
    }
  }

  std::vector<NamedMaterial> materials_;
};

using AllTypes = ::testing::Types<InOut<float, float>, InOut<float, double>, InOut<double, double>>;
TYPED_TEST_SUITE(BatchOf, AllTypes);

TYPED_TEST(BatchOf, AnySizeGivesTheSame) {
  using Out = typename TypeParam::Out;
  const auto pairs = random_pairs<typename TypeParam::In>(6000);
  this->for_all([&](const Material& material, Isa isa) {
    const auto channels = static_cast<std::size_t>(material.channels());
    const std::vector<Out> want = this->one_by_one(material, pairs, isa);
    std::vector<std::size_t> sizes{0,   127,  255,  256,  257,  511, 512,
                                   513, 1023, 4095, 4096, 4097, 6000};
    for (std::size_t size = 1; size <= 100; ++size) sizes.push_back(size);
    for (const std::size_t size : sizes) {
      const std::size_t first = (pairs.size() - size) / 3;
      constexpr Out kUntouched = -7;
      std::vector<Out> got(size * channels + 16, kUntouched);
      evaluate(material, batch_of(pairs, first, size, got.data(), material.channels(), nullptr),
               isa);
      ASSERT_TRUE(same_bits(got.data(), want.data() + first * channels, size * channels)) << size;
      for (std::size_t i = 0; i < 16; ++i) ASSERT_EQ(got[size * channels + i], kUntouched) << size;
    }
  });
}

TYPED_TEST(BatchOf, AnyLayoutGivesTheSame) {
  using In = typename TypeParam::In;
  using Out = typename TypeParam::Out;
  for (const std::size_t count :
       {std::size_t{1}, std::size_t{37}, std::size_t{512}, std::size_t{1003}}) {
    const Pairs<In> pairs = random_pairs<In>(count, 2);
    // As separate arrays, and every fifth of one array.
    std::array<std::vector<In>, 6> separate;
    std::vector<In> spread(count * 30, In(9));
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t c = 0; c < 6; ++c) {
        const In value = c < 3 ? pairs.wi[3 * i + c] : pairs.wo[3 * i + c - 3];
        separate[c].push_back(value);
        spread[30 * i + 5 * c] = value;
      }
    }
    struct Layout {
      Directions<In> wi, wo;
    };
    const std::vector<Layout> inputs{
        {Directions<In>::interleaved(pairs.wi.data()),
         Directions<In>::interleaved(pairs.wo.data())},
        {Directions<In>::separate(separate[0].data(), separate[1].data(), separate[2].data()),
         Directions<In>::separate(separate[3].data(), separate[4].data(), separate[5].data())},
        {{spread.data(), spread.data() + 5, spread.data() + 10, 30},
         {spread.data() + 15, spread.data() + 20, spread.data() + 25, 30}},
        {Directions<In>::separate(separate[0].data(), separate[1].data(), separate[2].data()),
         Directions<In>::interleaved(pairs.wo.data())}};
    this->for_all([&](const Material& material, Isa isa) {
      const int channels = material.channels();
      const auto n = static_cast<std::size_t>(channels);
      const std::vector<Out> want = this->one_by_one(material, pairs, isa);
      for (const Layout& input : inputs) {
        for (const auto& [pair_stride, channel_stride] :
             {std::pair{n, std::size_t{1}}, std::pair{std::size_t{1}, count},
              std::pair{n + 3, std::size_t{1}}, std::pair{3 * n, std::size_t{3}},
              std::pair{std::size_t{1}, count + 5}, std::pair{std::size_t{2}, 2 * count}}) {
          std::vector<Out> got(2 * (count + 5) * (n + 3) + 3 * n * count);
          std::vector<std::uint8_t> flags(count, 255);
          evaluate(material,
                   Batch<In, Out>{input.wi,
                                  input.wo,
                                  count,
                                  {got.data(), static_cast<std::ptrdiff_t>(pair_stride),
                                   static_cast<std::ptrdiff_t>(channel_stride)},
                                  flags.data()},
                   isa);
          for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(flags[i], 0);
            for (std::size_t c = 0; c < n; ++c) {
              ASSERT_TRUE(
                  same_bits(&got[i * pair_stride + c * channel_stride], &want[i * n + c], 1))
                  << "pair " << i << " of " << count << ", channel " << c << ", strides "
                  << pair_stride << " " << channel_stride;
            }
          }
        }
      }
    });
  }
}

TYPED_TEST(BatchOf, AnyNumberOfThreadsGivesTheSame) {
  using Out = typename TypeParam::Out;
  const auto pairs = random_pairs<typename TypeParam::In>(20011, 3);
  this->for_all([&](const Material& material, Isa isa) {
    const auto channels = static_cast<std::size_t>(material.channels());
    std::vector<Out> want(pairs.size() * channels);
    evaluate(material, batch_of(pairs, 0, pairs.size(), want.data(), material.channels(), nullptr),
             isa);
    for (const int threads : {1, 2, 3, 4}) {
      ThreadPool pool(threads, 4);
      for (const std::size_t count :
           {std::size_t{1}, std::size_t{3000}, std::size_t{8192}, pairs.size()}) {
        std::vector<Out> got(count * channels);
        std::vector<std::uint8_t> flags(count, 255);
        const auto batch = batch_of(pairs, 0, count, got.data(), material.channels(), flags.data());
        EXPECT_EQ(evaluate(material, batch, isa, pool), 0);
        ASSERT_TRUE(same_bits(got.data(), want.data(), got.size()))
            << threads << " threads, " << count;
        for (const std::uint8_t f : flags) ASSERT_EQ(f, 0);
      }
    }
  });
}

}  // namespace
}  // namespace gonio::testing
