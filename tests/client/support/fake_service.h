// A service that answers with a simple formula and misbehaves on request: what a client must cope
// with.
//
// It speaks the generated API, so it also shows that the client's own encoding is plain protobuf.
#pragma once

#include <grpcpp/grpcpp.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/happens_before.h"
#include "gonio/v1/service.grpc.pb.h"

namespace gonio::test {

inline constexpr int kFakeChannels = 2;
inline float fake_value(float wi_z, float wo_z, int channel) {
  return wi_z + 2 * wo_z + static_cast<float>(channel);
}

class FakeService final : public v1::GonioService::Service {
 public:
  // What to do; set before the server's address is asked for.
  std::atomic<int> unary_failures{0};  // fail this many calls with `failure`
  grpc::Status failure{grpc::StatusCode::UNAVAILABLE, "not now"};
  std::string pushback;  // trailing metadata of a failed call; empty for none
  std::function<void(v1::EvaluateResponse&)> spoil = [](auto&) {};
  std::function<void(v1::SampleResponse&)> spoil_samples = [](auto&) {};
  std::atomic<int> break_after{-1};    // end a stream after so many answers, once
  bool reverse = false;                // answer chunks two by two, the second first
  std::atomic<int> chunk_failures{0};  // answer so many chunks with `chunk_error`
  v1::ErrorDetail chunk_error;
  std::chrono::milliseconds delay{0};  // before every answer

  // What happened.
  std::atomic<int> unary_calls{0}, streams{0}, chunks{0}, materials{0};
  std::atomic<std::uint64_t> last_sequence{0};

  grpc::Status Evaluate(grpc::ServerContext* context, const v1::EvaluateRequest* request,
                        v1::EvaluateResponse* response) override {
    const Handling handling(*this);
    ++unary_calls;
    std::this_thread::sleep_for(delay);
    if (unary_failures > 0) {
      --unary_failures;
      if (!pushback.empty()) context->AddTrailingMetadata("grpc-retry-pushback-ms", pushback);
      return failure;
    }
    fill(*request, *response);
    return grpc::Status::OK;
  }

  grpc::Status EvaluateStream(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::EvaluateStreamResponse, v1::EvaluateStreamRequest>* stream)
      override {
    const Handling handling(*this);
    ++streams;
    v1::EvaluateStreamRequest request;
    std::vector<v1::EvaluateStreamResponse> held;
    int answered = 0;
    bool seen_material = false;
    while (stream->Read(&request)) {
      ++chunks;
      if (request.evaluate().has_material()) ++materials;
      seen_material = seen_material || request.evaluate().has_material();
      if (!seen_material) return {grpc::StatusCode::INVALID_ARGUMENT, "no material"};
      std::this_thread::sleep_for(delay);
      if (context->IsCancelled()) return grpc::Status::CANCELLED;
      held.push_back(answer(request));
      if (break_after >= 0 && answered >= break_after) {
        break_after = -1;
        if (!pushback.empty()) context->AddTrailingMetadata("grpc-retry-pushback-ms", pushback);
        return failure;
      }
      if (reverse && held.size() < 2 && request.sequence() + 1 < last_sequence) continue;
      for (; !held.empty(); held.pop_back(), ++answered) stream->Write(held.back());
    }
    for (; !held.empty(); held.pop_back()) stream->Write(held.back());
    return grpc::Status::OK;
  }

  // The pdf of a sample is its number in the whole request.
  grpc::Status SampleStream(grpc::ServerContext* /*context*/,
                            grpc::ServerReaderWriter<v1::SampleStreamResponse,
                                                     v1::SampleStreamRequest>* stream) override {
    const Handling handling(*this);
    ++streams;
    v1::SampleStreamRequest request;
    for (int answered = 0; stream->Read(&request); ++answered) {
      if (break_after >= 0 && answered >= break_after) {
        break_after = -1;
        return failure;
      }
      const v1::SampleRequest& asked = request.sample();
      v1::SampleStreamResponse response;
      response.set_sequence(request.sequence());
      v1::SampleResponse& samples = *response.mutable_sample();
      samples.set_channels(1);
      for (std::uint64_t i = 0; i < asked.count(); ++i) {
        samples.add_pdf(static_cast<float>(asked.first_wi() * asked.per_wi() + asked.first() + i));
        samples.add_weights(asked.wi(static_cast<int>(3 * ((asked.first() + i) / asked.per_wi()))));
      }
      samples.mutable_wo()->Resize(static_cast<int>(3 * asked.count()), 0);
      spoil_samples(samples);
      stream->Write(response);
    }
    return grpc::Status::OK;
  }

 private:
  // gRPC brings a call to its handler after all that its client did before, and ends calls and
  // server after the handlers.
  struct Handling {
    explicit Handling(const FakeService& of) : service(of) { happens_after(&service); }
    ~Handling() { happens_before(&service.streams); }
    Handling(const Handling&) = delete;
    Handling& operator=(const Handling&) = delete;
    const FakeService& service;
  };

  v1::EvaluateStreamResponse answer(const v1::EvaluateStreamRequest& request) {
    v1::EvaluateStreamResponse response;
    response.set_sequence(request.sequence());
    if (chunk_failures > 0) {
      --chunk_failures;
      *response.mutable_error() = chunk_error;
    } else {
      fill(request.evaluate(), *response.mutable_evaluate());
    }
    return response;
  }

  void fill(const v1::EvaluateRequest& request, v1::EvaluateResponse& response) const {
    const auto& pairs = request.pairs();
    response.set_channels(kFakeChannels);
    for (int i = 2; i < pairs.wi_size(); i += 3) {
      for (int c = 0; c < kFakeChannels; ++c) {
        response.add_values(fake_value(pairs.wi(i), pairs.wo(i), c));
      }
    }
    spoil(response);
  }
};

// Serves a FakeService on a free port of the loopback interface.
struct FakeServer {
  FakeService service;
  int port = 0;
  std::unique_ptr<grpc::Server> server;

  FakeServer() {
    grpc::ServerBuilder builder;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
    builder.RegisterService(&service);
    server = builder.BuildAndStart();
  }
  ~FakeServer() {
    server->Shutdown(std::chrono::system_clock::now());
    handlers_ended();
  }
  void handlers_ended() const { happens_after(&service.streams); }
  [[nodiscard]] std::string address() const {
    happens_before(&service);
    return "127.0.0.1:" + std::to_string(port);
  }
};

}  // namespace gonio::test
