// goniod run by a test: to its end, or as a server that is asked.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "server/support/daemon.h"
#include "server/support/harness.h"

namespace gonio::server::testing {

inline std::unique_ptr<v1::GonioService::Stub> stub_for(const std::string& target) {
  return v1::GonioService::NewStub(grpc::CreateChannel(target, grpc::InsecureChannelCredentials()));
}

inline grpc::Status evaluate_at(const std::string& target) {
  grpc::ClientContext context;
  v1::EvaluateResponse response;
  return stub_for(target)->Evaluate(&context, ggx_request(random_pairs(5000)), &response);
}

// Of a process that ends by itself.
inline std::pair<int, std::string> run(const std::vector<std::string>& arguments) {
  Daemon daemon(arguments);
  const std::string output = daemon.all_output();
  return {daemon.wait_for_exit(), output};
}

}  // namespace gonio::server::testing
