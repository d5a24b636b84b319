// One Chart call: the measurements, with their progress. Thread safety: see progress_call.h.
#pragma once

#include "server/calls/progress_call.h"
#include "server/messages/chart_request.h"

namespace gonio::server {

class ChartCall final : public ProgressCall {
 public:
  ChartCall(const Backend& backend, grpc::CallbackServerContext& context);

 private:
  Result<std::size_t> prepare(const grpc::ByteBuffer& request) override;
  Result<grpc::ByteBuffer> work() override;

  ChartTask task_;
};

}  // namespace gonio::server
