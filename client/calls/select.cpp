#include <optional>
#include <utility>

#include "client/calls/state.h"
#include "client/messages/select_convert.h"
#include "client/rpc/progress_call.h"
#include "gonio/client/client.h"
#include "wire/message.h"

namespace gonio::client {

Result<Selection> Client::select(const SelectReference& reference, const SelectScene& scene,
                                 const SelectOptions& options, const SelectWatch& watch) const {
  const auto request = select_request(reference, scene, options);
  if (!request) return request.error();
  std::optional<gonio::v1::SelectResult> result;
  const auto take = [&](grpc::ByteBuffer& bytes) {
    gonio::v1::SelectResponse response;
    if (!wire::from_buffer(bytes, response)) return false;
    if (response.has_result()) result = std::move(*response.mutable_result());
    if (response.has_progress() && watch.progress) watch.progress(progress_of(response.progress()));
    return result.has_value();
  };
  Patience patience(state_->options, options.deadline);
  const auto done = call_with_progress(state_->peer, {kSelectMethod, "the selection"},
                                       wire::to_buffer(*request), patience, watch.stop, take);
  if (!done) return done.error();
  return selection_of(*result);
}

}  // namespace gonio::client
