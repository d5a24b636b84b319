// Samples drawn by a server, in arrays. Thread safety: one test at a time.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "client/support/pairs.h"
#include "client/support/server_fixture.h"
#include "gonio/client/client.h"

namespace gonio::test {

template <class T>
struct Drawn {
  std::vector<T> wo, pdf, weights;
  std::vector<std::uint8_t> flags;

  explicit Drawn(std::size_t samples)
      : wo(3 * samples, T{-1}), pdf(samples, T{-1}), weights(3 * samples), flags(samples, 255) {}
  [[nodiscard]] client::Samples<T> results() { return {wo, pdf, weights, flags}; }
  bool operator==(const Drawn&) const = default;
};

// Directions above the horizon.
template <class T>
std::vector<T> directions(std::size_t count) {
  std::vector<T> wi = RandomPairs<T>(count).wi;
  for (std::size_t i = 2; i < wi.size(); i += 3)
    wi[i] = std::max(std::abs(wi[i]), static_cast<T>(1e-3));
  return wi;
}

class SampleTest : public ServerFixture {
 protected:
  template <class T>
  static Drawn<T> drawn(const client::Client& client, const client::SampleBatch<T>& batch,
                        std::size_t samples, client::Report* report = nullptr) {
    Drawn<T> to(samples);
    auto said = client.sample(ggx(), batch, to.results());
    EXPECT_TRUE(said.ok()) << said.error().message;
    if (said && report != nullptr) *report = *said;
    return to;
  }
};

}  // namespace gonio::test
