// A gonio server in this process, set up as goniod's, with the echo beside the service: same port,
// same threads.
#pragma once

#include <grpcpp/grpcpp.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <thread>

#include "bench/echo_service.h"
#include "server/configure.h"
#include "server/service.h"
#include "server/work/background_queue.h"

namespace gonio::bench {

class WireServer {
 public:
  explicit WireServer(std::size_t echo_bytes)
      : unix_target("unix:/tmp/gonio-bench-" + std::to_string(::getpid())), echo_(echo_bytes) {
    grpc::ServerBuilder builder;
    server::configure(builder, options_);
    builder.RegisterService(&service_).RegisterService(&echo_);
    int port = 0;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
    builder.AddListeningPort(unix_target, grpc::InsecureServerCredentials());
    server_ = builder.BuildAndStart();
    tcp_target = "127.0.0.1:" + std::to_string(port);
  }
  ~WireServer() { server_->Shutdown(); }

  std::string tcp_target, unix_target;

 private:
  server::ServerOptions options_;
  server::Materials materials_;
  ThreadPool pool_{std::max(1, static_cast<int>(std::thread::hardware_concurrency())),
                   options_.max_queued_jobs};
  spdlog::logger logger_{"bench", std::make_shared<spdlog::sinks::null_sink_mt>()};
  server::MemoryBudget memory_{options_.memory_quota_bytes};
  server::BackgroundQueue fits_{1, 1}, puts_{1, 1};
  server::CallsUnderWay calls_;
  server::Service service_{{materials_, pool_, options_.max_message_bytes, options_.max_queued_jobs,
                            logger_, memory_, server::FitBackend{fits_, std::chrono::seconds(1)},
                            puts_, calls_}};
  EchoService echo_;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace gonio::bench
