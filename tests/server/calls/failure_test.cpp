// Work that throws ends its call, with a line of the log, and the server goes on.
#include "server/calls/failure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <mutex>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>

#include "server/calls/progress_call.h"
#include "server/calls/start_calls.h"
#include "server/calls/stream_call.h"
#include "server/calls/unary_call.h"
#include "server/service.h"
#include "server/support/harness.h"
#include "server/support/stream_client.h"
#include "wire/message.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

struct Fault {
  enum class At { nowhere, prepare, work, answer };
  At at = At::nowhere;
  std::exception_ptr thrown;
};

// What the next calls meet. Thread safety: any thread.
class Faults {
 public:
  void set(const Fault& fault) {
    const std::lock_guard lock(mutex_);
    fault_ = fault;
  }
  void pass(Fault::At here) {
    const std::lock_guard lock(mutex_);
    if (fault_.at == here) std::rethrow_exception(fault_.thrown);
  }

 private:
  std::mutex mutex_;
  Fault fault_;
};

Faults faults;

// Takes an Evaluate request and answers nothing.
class FaultyWork final : public Work {
 public:
  using Request = wire::Request;
  static constexpr const char* kMethod = "Evaluate";
  static constexpr const char* kStreamMethod = "EvaluateStream";
  static constexpr const char* kItems = "pairs";

  static Result<std::shared_ptr<FaultyWork>> prepare(const Request& request,
                                                     PreparedMaterial material, std::size_t) {
    faults.pass(Fault::At::prepare);
    std::shared_ptr<FaultyWork> work(new FaultyWork(std::move(material)));
    work->set_size(request.wi.count / 3, request.bytes.size());
    return work;
  }
  void run_tile(std::size_t) override { faults.pass(Fault::At::work); }
  static wire::ResponseParts take_answer() {
    faults.pass(Fault::At::answer);
    return {};
  }

 private:
  explicit FaultyWork(PreparedMaterial material) : Work(std::move(material), Settings{}, false) {}
};

class FaultyFit final : public ProgressCall {
 public:
  FaultyFit(const Backend& backend, grpc::CallbackServerContext& context)
      : ProgressCall(backend, context, "Fit", "the fit") {
    note(wire::to_buffer(v1::FitResponse()));
  }

 private:
  Result<std::size_t> prepare(const grpc::ByteBuffer&) override {
    faults.pass(Fault::At::prepare);
    return 1;
  }
  Result<grpc::ByteBuffer> work() override {
    faults.pass(Fault::At::work);
    return wire::to_buffer(v1::FitResponse());
  }
};

class FaultyService final : public RawService {
 public:
  explicit FaultyService(const Backend& backend) : backend_(backend) { backend_.server_begins(); }
  ~FaultyService() override { backend_.server_ended(); }

  UnaryReactor* Evaluate(grpc::CallbackServerContext* context, const grpc::ByteBuffer* request,
                         grpc::ByteBuffer* response) override {
    backend_.call_begins();
    return UnaryCall<FaultyWork>::start(backend_, *context, *request, *response);
  }
  StreamReactor* EvaluateStream(grpc::CallbackServerContext* context) override {
    backend_.stream_begins();
    return StreamCall<FaultyWork>::start(backend_, *context);
  }
  ProgressReactor* Fit(grpc::CallbackServerContext* context,
                       const grpc::ByteBuffer* request) override {
    backend_.call_begins();
    return ProgressCall::start<FaultyFit>(backend_, *context, *request);
  }

 private:
  Backend backend_;
};

class Failure : public ::testing::Test {
 protected:
  Failure() {
    grpc::ServerBuilder builder;
    builder.RegisterService(&service_);
    server_ = builder.BuildAndStart();
    stub_ = v1::GonioService::NewStub(server_->InProcessChannel({}));
  }
  ~Failure() override {
    faults.set({});
    server_->Shutdown();
  }

  grpc::Status evaluate(std::size_t pairs) {
    grpc::ClientContext context;
    v1::EvaluateResponse response;
    return stub_->Evaluate(&context, ggx_request(random_pairs(pairs)), &response);
  }
  grpc::Status fit() {
    grpc::ClientContext context;
    const auto call = stub_->Fit(&context, v1::FitRequest());
    v1::FitResponse response;
    while (call->Read(&response)) {
    }
    return call->Finish();
  }
  [[nodiscard]] v1::GonioService::Stub& stub() const { return *stub_; }
  [[nodiscard]] std::string take_log() {
    std::string text = log_.str();
    log_.str("");
    return text;
  }
  [[nodiscard]] std::size_t held_memory() const { return memory_.held(); }

 private:
  std::ostringstream log_;
  Materials materials_;
  MemoryBudget memory_{std::size_t{1} << 30};
  ThreadPool pool_{2, 8};
  spdlog::logger logger_{"test", std::make_shared<spdlog::sinks::ostream_sink_mt>(log_)};
  BackgroundQueue fits_{1, 4}, puts_{1, 1};
  CallsUnderWay calls_;
  FaultyService service_{{materials_, pool_, std::size_t{64} << 20, 8, logger_, memory_,
                          FitBackend{fits_, std::chrono::seconds(60)}, puts_, calls_}};
  std::unique_ptr<grpc::Server> server_;
  std::unique_ptr<v1::GonioService::Stub> stub_;
};

struct Case {
  std::exception_ptr thrown;
  grpc::StatusCode code;
  std::string words;
};

std::vector<Case> cases() {
  return {
      {std::make_exception_ptr(std::bad_variant_access()), grpc::StatusCode::INTERNAL,
       std::bad_variant_access().what()},
      {std::make_exception_ptr(std::bad_alloc()), grpc::StatusCode::RESOURCE_EXHAUSTED,
       std::bad_alloc().what()},
      {std::make_exception_ptr(std::runtime_error("a cold kettle")), grpc::StatusCode::INTERNAL,
       "a cold kettle"},
      {std::make_exception_ptr(1), grpc::StatusCode::INTERNAL, "an exception of an unknown kind"}};
}

TEST_F(Failure, OfABatchEndsItsCallAlone) {
  for (const Case& one : cases()) {
    for (const auto at : {Fault::At::prepare, Fault::At::work, Fault::At::answer}) {
      // The small ones are computed by gRPC's threads, the others by the pool's.
      for (const std::size_t pairs : {1, 2, 3, 5, 4001}) {
        faults.set({at, one.thrown});
        EXPECT_EQ(evaluate(pairs).error_code(), one.code) << pairs;
        EXPECT_THAT(take_log(), HasSubstr("Evaluate failed: " + one.words));
        faults.set({});
        EXPECT_TRUE(evaluate(pairs).ok());
      }
    }
  }
  while (held_memory() > 0) std::this_thread::yield();
}

TEST_F(Failure, OfAChunkIsItsAnswerAndTheStreamGoesOn) {
  for (const Case& one : cases()) {
    for (const auto at : {Fault::At::prepare, Fault::At::work, Fault::At::answer}) {
      for (const std::size_t chunk : {1, 2, 3, 5, 4001}) {
        faults.set({at, one.thrown});
        const auto failed = stream(stub(), chunked(random_pairs(20 * chunk), chunk));
        EXPECT_TRUE(failed.status.ok()) << failed.status.error_message();
        ASSERT_EQ(failed.answers.size(), 20U);
        for (const auto& [sequence, answer] : failed.answers)
          EXPECT_EQ(answer.error().code(), one.code);
        EXPECT_THAT(take_log(), HasSubstr("EvaluateStream failed: " + one.words));
        faults.set({});
        EXPECT_TRUE(
            stream(stub(), chunked(random_pairs(chunk), chunk)).answers.at(0).has_evaluate());
      }
    }
  }
  while (held_memory() > 0) std::this_thread::yield();
}

TEST_F(Failure, OfWorkInTheBackgroundEndsItsCallAlone) {
  for (const Case& one : cases()) {
    for (const auto at : {Fault::At::prepare, Fault::At::work}) {
      faults.set({at, one.thrown});
      EXPECT_EQ(fit().error_code(), one.code);
      EXPECT_THAT(take_log(), HasSubstr("Fit failed: " + one.words));
      faults.set({});
      EXPECT_TRUE(fit().ok());
    }
  }
}

TEST_F(Failure, SaysToTheCallerWhatWasThrown) {
  faults.set({Fault::At::work, std::make_exception_ptr(std::runtime_error("a \n cold kettle"))});
  EXPECT_THAT(fit().error_message(), HasSubstr("Fit: a \\n cold kettle"));
  faults.set({Fault::At::work, std::make_exception_ptr(std::bad_alloc())});
  EXPECT_EQ(fit().error_message(), "no memory for this call of Fit");
}

}  // namespace
}  // namespace gonio::server::testing
