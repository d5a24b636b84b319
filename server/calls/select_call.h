// One Select call: the selection, with its progress. Thread safety: see progress_call.h.
#pragma once

#include "server/calls/progress_call.h"
#include "server/messages/select_request.h"

namespace gonio::server {

class SelectCall final : public ProgressCall {
 public:
  SelectCall(const Backend& backend, grpc::CallbackServerContext& context);

 private:
  Result<std::size_t> prepare(const grpc::ByteBuffer& request) override;
  Result<grpc::ByteBuffer> work() override;
  Result<select::Selection> choose();

  SelectTask task_;
};

}  // namespace gonio::server
