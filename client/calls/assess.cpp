#include <utility>

#include "client/calls/state.h"
#include "client/messages/assess_request.h"
#include "client/messages/convert.h"
#include "client/messages/message_json.h"
#include "client/transfer/check_answer.h"
#include "gonio/client/client.h"
#include "gonio/v1/assess.pb.h"
#include "wire/mapping/assessment.h"
#include "wire/message.h"

namespace gonio::client {
namespace {

namespace v1 = gonio::v1;

Result<Assessment> assessment_of(const v1::AssessResponse& response) {
  auto json = json_of(response);
  if (!json) return json.error();
  Assessment to;
  if (auto read = wire::read<gonio::assess::Assessment>(response, to); !read) return read.error();
  to.instruction_set = instruction_set_of(response.instruction_set());
  to.json = std::move(*json);
  return to;
}

}  // namespace

Result<Assessment> Client::assess(const Material& material, const AssessOptions& options) const {
  const auto request = assess_request(material, options);
  if (!request) return request.error();
  Patience patience(state_->options, options.deadline);
  auto bytes = call(state_->peer, kAssessMethod, wire::to_buffer(*request), patience);
  if (!bytes) return bytes.error();
  v1::AssessResponse response;
  if (!wire::from_buffer(*bytes, response)) return malformed(state_->peer, "it cannot be read");
  return assessment_of(response);
}

}  // namespace gonio::client
