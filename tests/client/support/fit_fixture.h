// Data of a known material for fits over the wire.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "client/support/server_fixture.h"
#include "fit/synthetic.h"

namespace gonio::test {

inline const MaterialSpec kTruth{{},
                                 LobeSpec{"lambertian", {{"rd", std::vector{0.3, 0.1, 0.05}}}},
                                 {LobeSpec{"ggx",
                                           {{"alpha_x", std::vector{0.2}},
                                            {"alpha_y", std::vector{0.2}},
                                            {"f0", std::vector{0.2}},
                                            {"fresnel", "schlick"}}}}};

// Pairs in float32, as they travel.
struct Measured {
  explicit Measured(std::size_t count) {
    const auto pairs = gonio::testing::scattered_pairs(count, 1);
    const auto data = gonio::testing::data_of(kTruth, pairs, 0.05);
    for (std::size_t i = 0; i < data.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        wi.push_back(data.wi[k][i]);
        wo.push_back(data.wo[k][i]);
        values.push_back(data.channel(static_cast<int>(k))[i]);
      }
    }
    weights = data.weights;
  }
  [[nodiscard]] client::FitData data() const { return {wi, wo, values, 3, weights, std::nullopt}; }
  std::vector<float> wi, wo, values, weights;
};

inline client::Material form() {
  return client::Material::sum(client::Lobe{"lambertian", {}},
                               {client::Lobe{"ggx", {{"fresnel", "schlick"}}}});
}

// A form whose fit is slow: many shapes, each lobe in the other's way.
inline client::Material slow_form() {
  const client::Lobe conductor{"ggx", {{"fresnel", "conductor"}}};
  const client::Lobe streaks{"ward", {}};
  return client::Material::sum(client::Lobe{"lambertian", {}}, {conductor, streaks});
}

class FitFixture : public ServerFixture {
 protected:
  void start_with(const std::function<void(server::ServerOptions&)>& change) {
    server::ServerOptions options;
    options.addresses = {"127.0.0.1:0", "unix:" + (folder_ / "socket").string()};
    change(options);
    server_.reset();  // the addresses are its own
    auto server = server::Server::start(options);
    ASSERT_TRUE(server.ok()) << server.error().message;
    server_ = std::move(server).value();
  }
};

}  // namespace gonio::test
