// A pair's value depends on the pair alone: not on the batch, its layout, or threads (bit for bit).
#include <gtest/gtest.h>

#include "engine/batches.h"
#include "gonio/engine/thread_pool.h"

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
    std::vector<std::size_t> sizes{0,   127,  255,  256,  257,  511,  512,
                                   513, 1023, 4001, 4095, 4096, 4097, 6000};
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

// The same pairs as separate arrays, and as every fifth number of one array.
template <class In>
struct Layouts {
  explicit Layouts(const Pairs<In>& pairs) : spread(pairs.size() * 30, In(9)) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (std::size_t c = 0; c < 6; ++c) {
        const In value = c < 3 ? pairs.wi[3 * i + c] : pairs.wo[3 * i + c - 3];
        separate[c].push_back(value);
        spread[30 * i + 5 * c] = value;
      }
    }
    const auto apart = [&](std::size_t c) {
      return Directions<In>::separate(separate[c].data(), separate[c + 1].data(),
                                      separate[c + 2].data());
    };
    const auto together = [](const std::vector<In>& w) {
      return Directions<In>::interleaved(w.data());
    };
    const In* s = spread.data();
    all = {{together(pairs.wi), together(pairs.wo)},
           {apart(0), apart(3)},
           {{s, s + 5, s + 10, 30}, {s + 15, s + 20, s + 25, 30}},
           {apart(0), together(pairs.wo)}};
  }
  std::array<std::vector<In>, 6> separate;
  std::vector<In> spread;
  std::vector<std::pair<Directions<In>, Directions<In>>> all;  // wi and wo
};

// The strides of pairs and channels of results.
std::vector<std::pair<std::size_t, std::size_t>> strides(std::size_t count, std::size_t channels) {
  return {{channels, 1},     {1, count},     {channels + 3, 1},
          {3 * channels, 3}, {1, count + 5}, {2, 2 * count}};
}

TYPED_TEST(BatchOf, AnyLayoutGivesTheSame) {
  using In = typename TypeParam::In;
  using Out = typename TypeParam::Out;
  for (const std::size_t count : {1, 37, 512, 1003}) {
    const Pairs<In> pairs = random_pairs<In>(count, 2);
    const Layouts<In> layouts(pairs);
    this->for_all([&](const Material& material, Isa isa) {
      const auto n = static_cast<std::size_t>(material.channels());
      const std::vector<Out> want = this->one_by_one(material, pairs, isa);
      for (const auto& [wi, wo] : layouts.all) {
        for (const auto& [pair, channel] : strides(count, n)) {
          std::vector<Out> got(2 * (count + 5) * (n + 3) + 3 * n * count);
          const Values<Out> to{got.data(), static_cast<std::ptrdiff_t>(pair),
                               static_cast<std::ptrdiff_t>(channel)};
          EXPECT_EQ(evaluate(material, Batch<In, Out>{wi, wo, count, to, nullptr}, isa), 0);
          for (std::size_t k = 0; k < count * n; ++k) {
            const std::size_t i = k / n, c = k % n;
            ASSERT_TRUE(same_bits(&got[i * pair + c * channel], &want[k], 1))
                << "pair " << i << " of " << count << ", channel " << c << ", strides " << pair
                << " " << channel;
          }
        }
      }
    });
  }
}

// Tiles and runs begin where results are aligned, wherever that is.
TYPED_TEST(BatchOf, ManyPairsGiveTheSame) {
  using In = typename TypeParam::In;
  using Out = typename TypeParam::Out;
  for (const NamedMaterial& m : this->materials_) {
    const auto channels = static_cast<std::size_t>(m.material.channels());
    const std::size_t count = 60'000 / channels + 37;
    const std::size_t stride = (count + 15) / 16 * 16;
    const Pairs<In> pairs = random_pairs<In>(count, 4);
    std::vector<Out> want(count * channels);
    for (std::size_t i = 0; i < count; i += 1000) {
      evaluate(m.material,
               batch_of(pairs, i, std::min<std::size_t>(1000, count - i), &want[i * channels],
                        m.material.channels(), nullptr),
               best_isa());
    }
    ThreadPool pool(1, 1);
    for (const std::size_t offset : {0, 1, 16}) {
      std::vector<Out> got(stride * channels + offset);
      auto batch = batch_of(pairs, 0, count, got.data(), m.material.channels(), nullptr);
      batch.values = {got.data() + offset, 1, static_cast<std::ptrdiff_t>(stride)};
      evaluate(m.material, batch, best_isa(), pool);
      for (std::size_t k = 0; k < count * channels; ++k) {
        ASSERT_TRUE(same_bits(&got[offset + k % channels * stride + k / channels], &want[k], 1))
            << m.name << ", pair " << k / channels << ", offset " << offset;
      }
    }
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
