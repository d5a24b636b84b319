// One Fit call: the fit, with its progress. Thread safety: see progress_call.h.
#pragma once

#include "gonio/v1/fit.pb.h"
#include "server/calls/progress_call.h"
#include "server/messages/fit_request.h"

namespace gonio::server {

class FitCall final : public ProgressCall {
 public:
  FitCall(const Backend& backend, grpc::CallbackServerContext& context);

 private:
  Result<std::size_t> prepare(const grpc::ByteBuffer& request) override;
  Result<grpc::ByteBuffer> work() override;

  v1::FitRequest request_;  // empty once the data are taken from it
  FitTask task_;
};

}  // namespace gonio::server
