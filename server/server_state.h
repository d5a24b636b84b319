// What a running server consists of. Thread safety: the service's parts are each safe by
// themselves; the rest is used by Server, which says how.
#pragma once

#include <grpcpp/server.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "gonio/base/result.h"
#include "gonio/engine/thread_pool.h"
#include "server/address.h"
#include "server/materials/materials.h"
#include "server/server.h"
#include "server/service.h"
#include "server/work/background_queue.h"
#include "server/work/calls_under_way.h"
#include "server/work/memory_budget.h"

namespace gonio::server {

// The options' logger, or one that writes nothing.
std::shared_ptr<spdlog::logger> logger_or_silence(const ServerOptions& options);

struct Server::State {
  State(const ServerOptions& given, Materials loaded);

  Outcome listen(const std::vector<Address>& addresses);
  void stop(std::chrono::milliseconds grace);

  ServerOptions options;
  std::shared_ptr<spdlog::logger> logger;
  Materials materials;
  MemoryBudget memory;
  CallsUnderWay calls;
  ThreadPool pool;             // outlived by nothing that uses it: the calls end with `grpc`
  BackgroundQueue fits, puts;  // likewise
  Service service;
  std::unique_ptr<grpc::Server> grpc;
  std::vector<SocketFile> socket_files;
  int port = 0;

  std::mutex mutex;
  std::condition_variable stopped_changed;
  bool stopping = false;
  bool stopped = false;
};

}  // namespace gonio::server
