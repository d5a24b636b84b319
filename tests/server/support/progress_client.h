// A plain client of the calls that send progress and end with a result: Fit, Select, Chart.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include "server/support/harness.h"

namespace gonio::server::testing {

template <class Result>
struct Answer {
  grpc::Status status;
  std::optional<Result> result;
  std::set<std::string> stages;
};

// On a call that has just begun. Cancels it after the first message where `cancel` says so.
template <class Response>
auto answer_of(grpc::ClientContext& context, grpc::ClientReader<Response>& call, bool cancel) {
  Answer<std::decay_t<decltype(std::declval<Response>().result())>> answer;
  Response response;
  while (call.Read(&response)) {
    if (response.has_result()) answer.result = response.result();
    if (response.has_progress()) answer.stages.insert(response.progress().stage());
    if (cancel) context.TryCancel();
  }
  answer.status = call.Finish();
  return answer;
}

inline auto ask(TestServer& server, const v1::SelectRequest& request, bool cancel = false) {
  grpc::ClientContext context;
  return answer_of(context, *server.stub->Select(&context, request), cancel);
}

inline auto ask(TestServer& server, const v1::ChartRequest& request, bool cancel = false) {
  grpc::ClientContext context;
  return answer_of(context, *server.stub->Chart(&context, request), cancel);
}

// Of a request that must fail.
template <class Request>
Error refused(TestServer& server, const Request& request) {
  const auto answer = ask(server, request);
  EXPECT_FALSE(answer.status.ok());
  EXPECT_FALSE(answer.result);
  return wire::from_status(answer.status);
}

}  // namespace gonio::server::testing
