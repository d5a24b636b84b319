// Requests too large in some way: an answer says so, nothing is allocated for them, and the server
// goes on.
#include <gmock/gmock.h>
#include <grpcpp/generic/generic_stub.h>
#include <gtest/gtest.h>

#include <thread>

#include "server/support/harness.h"
#include "server/support/raw_call.h"
#include "wire/fields.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

v1::EvaluateRequest grid_of(int per_axis) {
  v1::EvaluateRequest request;
  set_ggx(*request.mutable_material());
  for (int i = 0; i < per_axis; ++i) {
    const double angle = 1.5 * i / per_axis;
    request.mutable_grid()->add_theta_i(angle);
    request.mutable_grid()->add_phi_i(angle);
    request.mutable_grid()->add_theta_o(angle);
    request.mutable_grid()->add_phi_o(angle);
  }
  return request;
}

TEST(Limits, AGridOfATrillionPairsIsRefusedWithTheMost) {
  TestServer server;
  const Error error = server.refused(grid_of(1000));
  EXPECT_EQ(error.code, ErrorCode::invalid_argument);
  EXPECT_EQ(error.field, "grid");
  EXPECT_THAT(error.value, HasSubstr("1000000000000"));
  // 64 MiB of answer at 3 floats and a flag.
  EXPECT_THAT(error.allowed, HasSubstr(std::to_string(((64U << 20) - 4096) / 13)));
}

TEST(Limits, GridSizesThatOverflowAreRefused) {
  TestServer server;
  // (2^17)^4 = 2^68 pairs.
  const Error error = server.refused(grid_of(1 << 17));
  EXPECT_EQ(error.field, "grid");
}

TEST(Limits, AGridWithTooManyAnglesIsRefused) {
  TestServer server;
  v1::EvaluateRequest request = grid_of(1);
  request.mutable_grid()->mutable_phi_o()->Resize((1 << 20) + 1, 0.5);
  const Error error = server.refused(request);
  EXPECT_EQ(error.field, "grid");
  EXPECT_THAT(error.allowed, HasSubstr("1048576 angles"));
}

TEST(Limits, TheLargestAnswerFitsAndOnePairMoreDoesNot) {
  ServerOptions options;
  options.max_message_bytes = 1 << 20;
  TestServer server(options);
  v1::EvaluateRequest request = grid_of(100);
  const std::uint64_t most = ((1U << 20) - 4096) / 13;
  request.mutable_grid()->set_count(most);
  EXPECT_EQ(server.evaluated(request).values_size(), static_cast<int>(3 * most));
  request.mutable_grid()->set_count(most + 1);
  EXPECT_EQ(server.refused(request).field, "grid");
  // In float64 the same pairs take more room.
  request.mutable_grid()->set_count(most);
  request.set_precision(v1::PRECISION_REFERENCE);
  EXPECT_EQ(server.refused(request).field, "grid");
}

TEST(Limits, AMaterialOfManyChannelsMultipliesTheAnswer) {
  ServerOptions options;
  options.max_message_bytes = 1 << 20;
  TestServer server(options);
  v1::EvaluateRequest request = request_for(random_pairs(10'000), 0, 10'000);
  auto& fields = *request.mutable_material()->mutable_parameters()->mutable_fields();
  request.mutable_material()->set_model("lambertian");
  for (int c = 0; c < 64; ++c)
    fields["rd"].mutable_list_value()->add_values()->set_number_value(0.5);
  const Error error = server.refused(request);
  EXPECT_EQ(error.field, "pairs");
  EXPECT_THAT(error.allowed, HasSubstr("64 channels"));
}

v1::EvaluateRequest lobes_request(int lobes) {
  v1::EvaluateRequest request = request_for(random_pairs(1), 0, 1);
  for (int i = 0; i < lobes; ++i) request.mutable_material()->add_specular();
  return request;
}

TEST(Limits, AMaterialOfTooManyBytesIsRefused) {
  TestServer server;
  const Error error = server.refused(lobes_request(200'000));
  EXPECT_EQ(error.code, ErrorCode::invalid_argument);
  EXPECT_EQ(error.field, "material");
  EXPECT_EQ(error.value, "400000 bytes");
  EXPECT_THAT(error.allowed, HasSubstr("262144"));
  EXPECT_EQ(server.refused(lobes_request(100'000)).field, "material.specular");
}

// A group is legal protobuf of which only the generated parser knows the end.
TEST(Limits, NoUnusualEncodingGetsALargeMaterialParsed) {
  TestServer server;
  const std::string group = "\xfb\x07\xfc\x07", unknown = "\xf8\x07\x01";
  const std::string request = lobes_request(200'000).SerializeAsString();
  v1::EvaluateStreamRequest chunk;
  *chunk.mutable_evaluate() = lobes_request(100'000);
  const std::string twice = chunk.SerializeAsString() + chunk.SerializeAsString();
  for (const auto& [method, bytes] :
       std::vector<std::pair<std::string, std::string>>{{"Evaluate", group + request},
                                                        {"Evaluate", request + unknown},
                                                        {"EvaluateStream", twice},
                                                        {"Sample", group + request},
                                                        {"SampleStream", twice},
                                                        {"Integrate", request + unknown}}) {
    const grpc::Slice slice(bytes);
    const auto [status, response] =
        raw_call(server.server->in_process_channel(), "/gonio.v1.GonioService/" + method,
                 grpc::ByteBuffer(&slice, 1));
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(wire::from_status(status).field, "material") << status.error_message();
  }
}

// One slice many times over, so that the test needs no gigabyte of its own.
grpc::ByteBuffer gigabyte_request() {
  const grpc::Slice block(std::size_t{16} << 20);
  std::string header;
  wire::put_header(header, v1::EvaluateRequest::kPairsFieldNumber, std::size_t{1} << 30);
  std::vector<grpc::Slice> slices = {grpc::Slice(header)};
  for (int i = 0; i < 64; ++i) slices.push_back(block);
  return {slices.data(), slices.size()};
}

TEST(Limits, AGigabyteIsRefusedAndTheServerLives) {
  ServerOptions options;
  options.addresses = {"127.0.0.1:0"};
  TestServer server(options);
  const auto channel = grpc::CreateChannel("127.0.0.1:" + std::to_string(server.server->port()),
                                           grpc::InsecureChannelCredentials());
  const auto [status, response] =
      raw_call(channel, "/gonio.v1.GonioService/Evaluate", gigabyte_request());
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(server.evaluated(ggx_request(random_pairs(5))).values_size(), 15);
}

TEST(Limits, ACompressedRequestIsRefusedAndTheServerLives) {
  ServerOptions options;
  options.addresses = {"127.0.0.1:0"};
  TestServer server(options);
  const auto stub = v1::GonioService::NewStub(grpc::CreateChannel(
      "127.0.0.1:" + std::to_string(server.server->port()), grpc::InsecureChannelCredentials()));
  v1::EvaluateRequest request = ggx_request(random_pairs(5));
  request.mutable_pairs()->mutable_wi()->Resize(3'000'000, 0);
  for (const auto algorithm : {GRPC_COMPRESS_GZIP, GRPC_COMPRESS_DEFLATE}) {
    grpc::ClientContext context;
    context.set_compression_algorithm(algorithm);
    v1::EvaluateResponse response;
    const grpc::Status status = stub->Evaluate(&context, request, &response);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::UNIMPLEMENTED) << status.error_message();
    EXPECT_THAT(status.error_message(), HasSubstr("ompression"));
  }
  EXPECT_EQ(server.evaluated(ggx_request(random_pairs(5))).values_size(), 15);
}

TEST(Limits, GarbageIsRefusedAndTheServerLives) {
  TestServer server;
  const auto channel = server.server->in_process_channel();
  for (const std::string garbage : {"\xff\xff\xff\xff", "\x22\x7f trunc", "\x0a\x03\x12\x01\xff"}) {
    const grpc::Slice slice(garbage);
    const auto [status, response] =
        raw_call(channel, "/gonio.v1.GonioService/Evaluate", grpc::ByteBuffer(&slice, 1));
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_THAT(status.error_message(), HasSubstr("not a"));
  }
  EXPECT_EQ(server.evaluated(ggx_request(random_pairs(5))).values_size(), 15);
}

TEST(Limits, ServerOptionsAreChecked) {
  const auto field_of_refusal = [](const ServerOptions& options) {
    const auto server = Server::start(options);
    EXPECT_FALSE(server.ok());
    return server ? "" : server.error().field;
  };
  EXPECT_EQ(field_of_refusal({.threads = -1}), "threads");
  EXPECT_EQ(field_of_refusal({.threads = 5000}), "threads");
  EXPECT_EQ(field_of_refusal({.max_queued_jobs = 0}), "max_queued_jobs");
  EXPECT_EQ(field_of_refusal({.max_message_bytes = 1}), "max_message_bytes");
  EXPECT_EQ(field_of_refusal({.max_message_bytes = std::size_t{3} << 30}), "max_message_bytes");
  EXPECT_EQ(field_of_refusal({.memory_quota_bytes = 1}), "memory_quota_bytes");
}

}  // namespace
}  // namespace gonio::server::testing
