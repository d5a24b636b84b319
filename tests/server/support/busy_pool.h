// A service whose compute pool a test can hold up: one thread, which waits in a job of the test's.
#pragma once

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <future>
#include <memory>
#include <sstream>
#include <utility>

#include "server/service.h"
#include "server/support/harness.h"
#include "server/work/background_queue.h"

namespace gonio::server::testing {

class BusyService {
 public:
  // `places`: how many jobs the queue takes, the blocking one included; `memory`: bytes.
  explicit BusyService(std::size_t places, std::size_t memory = std::size_t{1} << 30)
      : memory_(memory),
        pool_(1, places),
        logger_("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log_)),
        service_({materials_, pool_, std::size_t{64} << 20, places, logger_, memory_,
                  FitBackend{fits_, std::chrono::seconds(1)}, puts_, calls_}) {
    logger_.set_level(spdlog::level::debug);
    EXPECT_TRUE(pool_.submit({1,
                              [this](std::size_t) {
                                begun_.set_value();
                                freed_.get_future().wait();
                              },
                              {},
                              {}}));
    begun_.get_future().wait();
    grpc::ServerBuilder builder;
    builder.RegisterService(&service_);
    server_ = builder.BuildAndStart();
    stub = v1::GonioService::NewStub(server_->InProcessChannel({}));
  }
  ~BusyService() {
    free();
    server_->Shutdown();
  }

  // Lets the compute thread go on.
  void free() {
    if (!std::exchange(is_free_, true)) freed_.set_value();
  }
  void stop_server() { server_->Shutdown(); }
  [[nodiscard]] std::string log() const { return log_.str(); }
  ThreadPool& pool() { return pool_; }
  MemoryBudget& memory() { return memory_; }

  std::unique_ptr<v1::GonioService::Stub> stub;

 private:
  std::promise<void> begun_, freed_;
  bool is_free_ = false;
  std::ostringstream log_;
  Materials materials_;
  MemoryBudget memory_;
  ThreadPool pool_;
  spdlog::logger logger_;
  BackgroundQueue fits_{1, 1}, puts_{1, 1};
  CallsUnderWay calls_;
  Service service_;
  std::unique_ptr<grpc::Server> server_;
};

}  // namespace gonio::server::testing
