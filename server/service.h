// The gRPC service: each handler translates, calls, translates. Evaluate and EvaluateStream take
// raw bytes, so that the large arrays never become messages.
//
// Thread safety: as gRPC calls it, from any thread.
#pragma once

#include "gonio/v1/service.grpc.pb.h"
#include "server/call.h"

namespace gonio {

using WireService = v1::GonioService;
using RawService = WireService::WithCallbackMethod_ListModels<
    WireService::WithRawCallbackMethod_Evaluate<WireService::WithRawCallbackMethod_EvaluateStream<
        WireService::WithRawCallbackMethod_Fit<WireService::Service>>>>;

class Service final : public RawService {
 public:
  explicit Service(const Backend& backend) : backend_(backend) {}

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

 private:
  Backend backend_;
};

}  // namespace gonio
