// One unary call, with its retries. Internal to the client library.
//
// A call has a completion queue to itself while it lasts, from a pool; the calling thread polls it:
// no thread is woken for an answer.
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>

#include <memory>
#include <string>

#include "client/rpc/queue_pool.h"
#include "client/rpc/retry.h"
#include "gonio/base/result.h"

namespace gonio::client {

// The server as the calls see it. Thread safe.
struct Peer {
  std::shared_ptr<grpc::Channel> channel;
  std::string name;  // in messages
  std::unique_ptr<QueuePool> queues = std::make_unique<QueuePool>();
};

inline constexpr const char* kEvaluateMethod = "/gonio.v1.GonioService/Evaluate";
inline constexpr const char* kEvaluateStreamMethod = "/gonio.v1.GonioService/EvaluateStream";
inline constexpr const char* kSampleMethod = "/gonio.v1.GonioService/Sample";
inline constexpr const char* kSampleStreamMethod = "/gonio.v1.GonioService/SampleStream";
inline constexpr const char* kIntegrateMethod = "/gonio.v1.GonioService/Integrate";
inline constexpr const char* kFitMethod = "/gonio.v1.GonioService/Fit";
inline constexpr const char* kPutMaterialMethod = "/gonio.v1.GonioService/PutMaterial";
inline constexpr const char* kAssessMethod = "/gonio.v1.GonioService/Assess";
inline constexpr const char* kChartMethod = "/gonio.v1.GonioService/Chart";
inline constexpr const char* kSelectMethod = "/gonio.v1.GonioService/Select";
inline constexpr const char* kListModelsMethod = "/gonio.v1.GonioService/ListModels";

Result<grpc::ByteBuffer> call(const Peer& peer, const char* method, const grpc::ByteBuffer& request,
                              Patience& patience);

}  // namespace gonio::client
