#include <optional>
#include <utility>

#include "client/calls/state.h"
#include "client/messages/fit_convert.h"
#include "client/rpc/progress_call.h"
#include "gonio/client/client.h"
#include "wire/message.h"

namespace gonio::client {

Result<FitResult> Client::fit(const FitData& data, const Material& form, const FitOptions& options,
                              const FitWatch& watch) const {
  const auto request = fit_request(data, form, options);
  if (!request) return request.error();
  std::optional<gonio::v1::FitResult> result;
  const auto take = [&](grpc::ByteBuffer& bytes) {
    gonio::v1::FitResponse response;
    if (!wire::from_buffer(bytes, response)) return false;
    if (response.has_result()) result = std::move(*response.mutable_result());
    if (response.has_progress() && watch.progress) watch.progress(progress_of(response.progress()));
    return result.has_value();
  };
  Patience patience(state_->options, options.deadline);
  const auto done = call_with_progress(state_->peer, {kFitMethod, "the fit"},
                                       wire::to_buffer(*request), patience, watch.stop, take);
  if (!done) return done.error();
  return fit_result_of(*result);
}

}  // namespace gonio::client
