// Health, reflection and the end of a server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "server/support/harness.h"
#include "server/support/raw_call.h"
#include "wire/bytes.h"
#include "wire/fields.h"

namespace gonio::server::testing {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

enum Health { kServing = 1, kNotServing = 2 };  // grpc.health.v1.HealthCheckResponse.ServingStatus

// The status of a service, or the negative code of a failed call. The messages are one string
// there, one number back.
int health(const std::shared_ptr<grpc::Channel>& channel, const std::string& service) {
  std::string request;
  if (!service.empty()) {
    wire::put_header(request, 1, service.size());
    request += service;
  }
  const grpc::Slice slice(request);
  const auto [status, response] =
      raw_call(channel, "/grpc.health.v1.Health/Check", grpc::ByteBuffer(&slice, 1));
  if (!status.ok()) return -status.error_code();
  const wire::SliceBytes bytes = wire::SliceBytes::of(response);
  wire::FieldReader fields(bytes, {0, bytes.size()});
  wire::Field field;
  return fields.next(field) ? static_cast<int>(field.varint) : 0;
}

TEST(Health, ServingByNameAndOverall) {
  TestServer server;
  const auto channel = server.server->in_process_channel();
  EXPECT_EQ(health(channel, ""), kServing);
  EXPECT_EQ(health(channel, "gonio.v1.GonioService"), kServing);
  EXPECT_EQ(health(channel, "other"), -grpc::StatusCode::NOT_FOUND);
}

TEST(Health, NotServingDuringTheLameDuckWhileCallsAreStillTaken) {
  ServerOptions options;
  options.lame_duck = 3s;
  options.addresses = {"127.0.0.1:0"};
  TestServer server(options);
  const auto channel = grpc::CreateChannel("127.0.0.1:" + std::to_string(server.server->port()),
                                           grpc::InsecureChannelCredentials());
  server.stub = v1::GonioService::NewStub(channel);
  std::thread stopping([&] { server.server->shutdown(1s); });
  int seen = kServing;
  while (seen == kServing) seen = health(channel, "gonio.v1.GonioService");
  EXPECT_EQ(seen, kNotServing);
  EXPECT_EQ(server.evaluated(ggx_request(random_pairs(5))).values_size(), 15);
  stopping.join();
  v1::EvaluateResponse response;
  EXPECT_EQ(server.evaluate(ggx_request(random_pairs(5)), &response).error_code(),
            grpc::StatusCode::UNAVAILABLE);
}

TEST(Reflection, ListsTheService) {
  TestServer server;
  std::string request;
  wire::put_header(request, 7, 0);  // ServerReflectionRequest.list_services
  const grpc::Slice slice(request);
  const auto [status, response] =
      raw_call(server.server->in_process_channel(),
               "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo",
               grpc::ByteBuffer(&slice, 1));
  ASSERT_TRUE(status.ok()) << status.error_message();
  const wire::SliceBytes bytes = wire::SliceBytes::of(response);
  EXPECT_THAT(bytes.text(0, bytes.size()), HasSubstr("gonio.v1.GonioService"));
}

TEST(Shutdown, CallsUnderWayAreFinished) {
  ServerOptions options;
  options.addresses = {"127.0.0.1:0"};
  TestServer server(options);
  server.stub = v1::GonioService::NewStub(grpc::CreateChannel(
      "127.0.0.1:" + std::to_string(server.server->port()), grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  const auto call = server.stub->EvaluateStream(&context);
  v1::EvaluateStreamRequest chunk;
  *chunk.mutable_evaluate() = ggx_request(random_pairs(10'000));
  ASSERT_TRUE(call->Write(chunk));
  v1::EvaluateStreamResponse answer;
  ASSERT_TRUE(call->Read(&answer));
  std::thread stopping([&] { server.server->shutdown(60s); });
  chunk.set_sequence(1);
  EXPECT_TRUE(call->Write(chunk));
  EXPECT_TRUE(call->Read(&answer));
  EXPECT_EQ(answer.sequence(), 1U);
  call->WritesDone();
  EXPECT_TRUE(call->Finish().ok());
  stopping.join();
  server.server->wait();
}

TEST(Shutdown, AnIdleStreamDoesNotOutliveTheGrace) {
  TestServer server;
  grpc::ClientContext context;
  const auto call = server.stub->EvaluateStream(&context);
  v1::EvaluateStreamRequest chunk;
  *chunk.mutable_evaluate() = ggx_request(random_pairs(1));
  ASSERT_TRUE(call->Write(chunk));
  v1::EvaluateStreamResponse answer;
  ASSERT_TRUE(call->Read(&answer));
  server.server->shutdown(10ms);
  EXPECT_FALSE(call->Read(&answer));
  EXPECT_FALSE(call->Finish().ok());
}

TEST(Shutdown, TheSecondWaitsForTheFirst) {
  ServerOptions options;
  options.lame_duck = 300ms;
  TestServer server(options);
  const auto start = std::chrono::steady_clock::now();
  std::thread first([&] { server.server->shutdown(0ms); });
  std::this_thread::sleep_for(20ms);
  server.server->shutdown(0ms);
  EXPECT_GE(std::chrono::steady_clock::now() - start, 300ms);
  first.join();
}

TEST(Shutdown, TwiceIsOnce) {
  TestServer server;
  server.server->shutdown(0ms);
  server.server->shutdown(0ms);
  server.server->wait();
}

}  // namespace
}  // namespace gonio::server::testing
