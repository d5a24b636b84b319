// The gRPC service: each handler translates, calls, translates. All but ListModels take
// raw bytes, so that large arrays never become messages.
//
// Thread safety: as gRPC calls it, from any thread.
#pragma once

#include "gonio/v1/service.grpc.pb.h"
#include "server/calls/call.h"

namespace gonio::server {

using WireService = v1::GonioService;
// Those that do not take messages.
using RawEvaluate = WireService::WithRawCallbackMethod_Evaluate<
    WireService::WithRawCallbackMethod_EvaluateStream<WireService::Service>>;
using RawSample = WireService::WithRawCallbackMethod_Sample<
    WireService::WithRawCallbackMethod_SampleStream<RawEvaluate>>;
using RawFit = WireService::WithRawCallbackMethod_Fit<RawSample>;
using RawPut = WireService::WithRawCallbackMethod_PutMaterial<RawFit>;
using RawAssess = WireService::WithRawCallbackMethod_Assess<RawPut>;
using RawSelect = WireService::WithRawCallbackMethod_Select<RawAssess>;
using RawChart = WireService::WithRawCallbackMethod_Chart<RawSelect>;
using RawService = WireService::WithCallbackMethod_ListModels<
    WireService::WithRawCallbackMethod_Integrate<RawChart>>;

class Service final : public RawService {
 public:
  explicit Service(const Backend& backend);
  ~Service() override;  // the server that it was registered with has ended

  grpc::ServerUnaryReactor* ListModels(grpc::CallbackServerContext* context,
                                       const v1::ListModelsRequest* request,
                                       v1::ListModelsResponse* response) override;
  grpc::ServerUnaryReactor* Evaluate(grpc::CallbackServerContext* context,
                                     const grpc::ByteBuffer* request,
                                     grpc::ByteBuffer* response) override;
  grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* EvaluateStream(
      grpc::CallbackServerContext* context) override;
  grpc::ServerWriteReactor<grpc::ByteBuffer>* Fit(grpc::CallbackServerContext* context,
                                                  const grpc::ByteBuffer* request) override;
  grpc::ServerReadReactor<grpc::ByteBuffer>* PutMaterial(grpc::CallbackServerContext* context,
                                                         grpc::ByteBuffer* response) override;
  grpc::ServerUnaryReactor* Assess(grpc::CallbackServerContext* context,
                                   const grpc::ByteBuffer* request,
                                   grpc::ByteBuffer* response) override;
  grpc::ServerWriteReactor<grpc::ByteBuffer>* Select(grpc::CallbackServerContext* context,
                                                     const grpc::ByteBuffer* request) override;

  grpc::ServerWriteReactor<grpc::ByteBuffer>* Chart(grpc::CallbackServerContext* context,
                                                    const grpc::ByteBuffer* request) override;

  grpc::ServerUnaryReactor* Sample(grpc::CallbackServerContext* context,
                                   const grpc::ByteBuffer* request,
                                   grpc::ByteBuffer* response) override;
  grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>* SampleStream(
      grpc::CallbackServerContext* context) override;
  grpc::ServerUnaryReactor* Integrate(grpc::CallbackServerContext* context,
                                      const grpc::ByteBuffer* request,
                                      grpc::ByteBuffer* response) override;

 private:
  Backend backend_;
};

}  // namespace gonio::server
