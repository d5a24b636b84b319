// Requests for samples, and the same samples straight from the core.
#pragma once

#include <cstdint>
#include <vector>

#include "gonio/engine/sampler.h"
#include "server/support/harness.h"

namespace gonio::server::testing {

inline std::vector<float> random_directions(std::size_t count, unsigned seed = 1) {
  return random_pairs(count, seed).wi;
}

inline v1::SampleRequest sample_request(const std::vector<float>& wi, std::uint64_t per_wi) {
  v1::SampleRequest request;
  set_ggx(*request.mutable_material());
  request.mutable_wi()->Add(wi.begin(), wi.end());
  request.set_per_wi(per_wi);
  return request;
}

template <class T>
struct CoreSamples {
  std::vector<T> wo, pdf, weights;
  std::vector<std::uint8_t> flags;
  SampleReport report;

  CoreSamples(const Material& material, const std::vector<T>& wi, std::uint64_t per_wi,
              const NumberSource& numbers, const T* xi = nullptr) {
    const std::size_t samples = wi.size() / 3 * per_wi;
    wo.resize(3 * samples), pdf.resize(samples), flags.resize(samples);
    weights.resize(samples * static_cast<std::size_t>(material.channels()));
    SampleBatch<T> batch;
    batch.wi = Directions<T>::interleaved(wi.data());
    batch.count = samples;
    batch.per_wi = per_wi;
    batch.xi = xi;
    batch.numbers = numbers;
    batch.wo = wo.data();
    batch.pdf = pdf.data();
    batch.weights = Values<T>::interleaved(weights.data(), material.channels());
    batch.flags = flags.data();
    report = sample(Sampler::create(material), batch, best_isa());
  }
};

template <class T, class Repeated>
std::vector<T> vector_of(const Repeated& numbers) {
  return {numbers.begin(), numbers.end()};
}

// One sample call that must succeed, and one that must not.
inline v1::SampleResponse sampled(TestServer& server, const v1::SampleRequest& request) {
  grpc::ClientContext context;
  v1::SampleResponse response;
  const grpc::Status status = server.stub->Sample(&context, request, &response);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return response;
}
inline Error sample_refused(TestServer& server, const v1::SampleRequest& request) {
  grpc::ClientContext context;
  v1::SampleResponse response;
  const grpc::Status status = server.stub->Sample(&context, request, &response);
  EXPECT_FALSE(status.ok());
  return wire::from_status(status);
}

inline grpc::Status integrate(TestServer& server, const v1::IntegrateRequest& request,
                              v1::IntegrateResponse* response) {
  grpc::ClientContext context;
  return server.stub->Integrate(&context, request, response);
}

}  // namespace gonio::server::testing
