// What the server's tests share: a server in this process, requests, and the same values straight
// from the core.
#pragma once

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "gonio/engine/evaluate.h"
#include "gonio/v1/service.grpc.pb.h"
#include "server/server.h"
#include "wire/status.h"

namespace gonio::server::testing {

struct TestServer {
  explicit TestServer(const ServerOptions& options = {}) {
    auto started = Server::start(options);
    EXPECT_TRUE(started.ok()) << (started ? "" : started.error().message);
    server = std::move(*started);
    stub = v1::GonioService::NewStub(server->in_process_channel());
  }

  grpc::Status evaluate(const v1::EvaluateRequest& request, v1::EvaluateResponse* response) {
    grpc::ClientContext context;
    return stub->Evaluate(&context, request, response);
  }
  // Of a request that must succeed.
  v1::EvaluateResponse evaluated(const v1::EvaluateRequest& request) {
    v1::EvaluateResponse response;
    const grpc::Status status = evaluate(request, &response);
    EXPECT_TRUE(status.ok()) << status.error_message();
    return response;
  }
  // Of a request that must fail.
  Error refused(const v1::EvaluateRequest& request) {
    v1::EvaluateResponse response;
    const grpc::Status status = evaluate(request, &response);
    EXPECT_FALSE(status.ok());
    EXPECT_FALSE(status.error_details().empty());
    return wire::from_status(status);
  }

  std::unique_ptr<Server> server;
  std::unique_ptr<v1::GonioService::Stub> stub;
};

struct PairArrays {
  std::vector<float> wi, wo;
  [[nodiscard]] std::size_t size() const { return wi.size() / 3; }
};

inline void add_direction(std::vector<float>& to, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double z = uniform(random), phi = 6.28318530717958648 * uniform(random),
               r = std::sqrt(1 - z * z);
  for (double c : {r * std::cos(phi), r * std::sin(phi), z}) to.push_back(static_cast<float>(c));
}

inline PairArrays random_pairs(std::size_t count, unsigned seed = 1) {
  std::mt19937 random(seed);
  PairArrays pairs;
  for (std::size_t i = 0; i < count; ++i) {
    add_direction(pairs.wi, random);
    add_direction(pairs.wo, random);
  }
  return pairs;
}

// Pairs first ... first + count - 1, as a request without a material.
inline v1::EvaluateRequest request_for(const PairArrays& pairs, std::size_t first,
                                       std::size_t count) {
  v1::EvaluateRequest request;
  const auto begin = static_cast<std::ptrdiff_t>(3 * first),
             end = static_cast<std::ptrdiff_t>(3 * (first + count));
  request.mutable_pairs()->mutable_wi()->Add(pairs.wi.begin() + begin, pairs.wi.begin() + end);
  request.mutable_pairs()->mutable_wo()->Add(pairs.wo.begin() + begin, pairs.wo.begin() + end);
  return request;
}

inline void set_ggx(v1::Material& material, double alpha = 0.2) {
  material.Clear();
  material.set_model("ggx");
  auto& fields = *material.mutable_parameters()->mutable_fields();
  for (double f0 : {1.0, 0.71, 0.29})
    fields["f0"].mutable_list_value()->add_values()->set_number_value(f0);
  fields["alpha_x"].set_number_value(alpha);
  fields["alpha_y"].set_number_value(alpha);
}

inline v1::EvaluateRequest ggx_request(const PairArrays& pairs) {
  v1::EvaluateRequest request = request_for(pairs, 0, pairs.size());
  set_ggx(*request.mutable_material());
  return request;
}

inline Material core_ggx(double alpha = 0.2) {
  MaterialSpec spec;
  spec.model = LobeSpec{"ggx",
                        {{"f0", std::vector<double>{1.0, 0.71, 0.29}},
                         {"alpha_x", std::vector<double>{alpha}},
                         {"alpha_y", std::vector<double>{alpha}}}};
  auto material = Material::create(spec);
  EXPECT_TRUE(material.ok());
  return *material;
}

// The core's own answer, all in one call on this thread.
template <class In, class Out>
std::vector<Out> core_values(const Material& material, const std::vector<In>& wi,
                             const std::vector<In>& wo, Isa isa = best_isa()) {
  const std::size_t count = wi.size() / 3;
  std::vector<Out> values(count * static_cast<std::size_t>(material.channels()));
  evaluate(
      material,
      Batch<In, Out>{Directions<In>::interleaved(wi.data()), Directions<In>::interleaved(wo.data()),
                     count, Values<Out>::interleaved(values.data(), material.channels()), nullptr},
      isa);
  return values;
}

}  // namespace gonio::server::testing
