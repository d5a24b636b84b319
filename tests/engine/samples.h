// Batches of samples for the tests of samplers.
#pragma once

#include <gtest/gtest.h>

#include "engine/batches.h"
#include "gonio/engine/sampler.h"

namespace gonio::testing {

// What is drawn, interleaved. What is not written shows as improper.
template <class T>
struct Drawn {
  std::vector<T> wo, pdf, weights;
  std::vector<std::uint8_t> flags;
  SampleReport report;

  Drawn(std::size_t count, int channels)
      : wo(3 * count, T(-7)),
        pdf(count, T(-7)),
        weights(count * static_cast<std::size_t>(channels), T(-7)),
        flags(count, 255) {}
};

// Samples `first` to `first + count` of `wi` (interleaved, from number 0 on), `per_wi` of each, by
// xi (likewise) or, if that is empty, by `numbers`.
template <class T>
struct Request {
  std::vector<T> wi;
  std::uint64_t per_wi = 1;
  std::vector<T> xi = {};
  NumberSource numbers = {};

  [[nodiscard]] std::size_t samples() const { return wi.size() / 3 * per_wi; }
};

template <class T>
Drawn<T> draw(const Sampler& sampler, const Request<T>& request, std::size_t first,
              std::size_t count, Isa isa) {
  const int channels = sampler.material().channels();
  Drawn<T> drawn(count, channels);
  SampleBatch<T> batch;
  batch.wi = Directions<T>::interleaved(request.wi.data() + 3 * (first / request.per_wi));
  batch.first = first;
  batch.count = count;
  batch.per_wi = request.per_wi;
  batch.xi = request.xi.empty() ? nullptr : request.xi.data() + 3 * first;
  batch.numbers = request.numbers;
  batch.wo = drawn.wo.data();
  batch.pdf = drawn.pdf.data();
  batch.weights = Values<T>::interleaved(drawn.weights.data(), channels);
  batch.flags = drawn.flags.data();
  drawn.report = sample(sampler, batch, isa);
  return drawn;
}

template <class T>
Drawn<T> draw(const Sampler& sampler, const Request<T>& request, Isa isa) {
  return draw(sampler, request, 0, request.samples(), isa);
}

// Whether samples `at` of `some` to `at + count` are, bit for bit, all of `others`.
template <class T>
::testing::AssertionResult same(const Drawn<T>& some, std::size_t at, const Drawn<T>& others) {
  const std::size_t count = others.pdf.size(), channels = others.weights.size() / count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = at + i;
    if (!same_bits(&some.wo[3 * from], &others.wo[3 * i], 3) ||
        !same_bits(&some.pdf[from], &others.pdf[i], 1) ||
        !same_bits(&some.weights[from * channels], &others.weights[i * channels], channels) ||
        some.flags[from] != others.flags[i]) {
      return ::testing::AssertionFailure() << "sample " << i << " of " << count << ", from " << at;
    }
  }
  return ::testing::AssertionSuccess();
}

// Each material with each instruction set.
template <class Body>
void for_all_samplers(const Body& body) {
  for (const NamedMaterial& m : all_kinds_of_material()) {
    const Sampler sampler = Sampler::create(m.material);
    for (const Isa isa : supported_isas()) {
      SCOPED_TRACE(m.name + ", " + std::string(name_of(isa)));
      body(sampler, isa);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

}  // namespace gonio::testing
