// Mutated and random bytes: the codec must agree with the generated parser on what is legal, and
// never touch memory that is not its own (the sanitizer builds watch).
#include <google/protobuf/stubs/logging.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "gonio/v1/evaluate.pb.h"
#include "wire/codec.h"
#include "wire/messages.h"
#include "wire/mutated.h"

namespace gonio::wire::testing {
namespace {

// The codec leaves the material to others.
bool is_legal(const Result<Request>& decoded) {
  return decoded.ok() && (!decoded->material || v1::Material().ParseFromString(*decoded->material));
}

// Reads every array, so that a wrong offset shows.
float touch(const Request& request) {
  float sum = 0;
  if (request.kind == Request::Kind::pairs) {
    for (float value : elements<float>(request.bytes, request.wi)) sum += value;
    for (float value : elements<float>(request.bytes, request.wo)) sum += value;
  } else if (request.kind == Request::Kind::pairs_f64) {
    for (double value : elements<double>(request.bytes, request.wi))
      sum += static_cast<float>(value);
  }
  return sum;
}

TEST(Fuzz, MutatedRequestsAgreeWithTheGeneratedParser) {
  const google::protobuf::LogSilencer silent;
  std::mt19937 random(20'000);
  int accepted = 0;
  constexpr int kRounds = 20'000;
  for (int round = 0; round < kRounds; ++round) {
    const std::string bytes =
        mutated(request_with_pairs(random() % 9, random).SerializeAsString(), random);
    v1::EvaluateRequest expected;
    const bool legal = expected.ParseFromString(bytes);
    const auto decoded = decode<Request>(buffer_of(bytes, 1 + random() % 40));
    ASSERT_EQ(is_legal(decoded), legal) << "round " << round;
    if (!decoded.ok()) {
      EXPECT_EQ(decoded.error().code, ErrorCode::invalid_argument);
    }
    if (!legal) continue;
    ++accepted;
    touch(*decoded);
    const auto wi =
        static_cast<std::size_t>(expected.pairs().wi_size() + expected.pairs_f64().wi_size());
    ASSERT_EQ(decoded->wi.count, wi) << "round " << round;
  }
  // Both sides of the fence were visited.
  EXPECT_GT(accepted, kRounds / 20);
  EXPECT_LT(accepted, kRounds - kRounds / 20);
}

TEST(Fuzz, MutatedStreamMessagesDoNotCrash) {
  const google::protobuf::LogSilencer silent;
  std::mt19937 random(30'000);
  for (int round = 0; round < 10'000; ++round) {
    v1::EvaluateStreamRequest request;
    request.set_sequence(random());
    request.set_slot(random() % 256);
    *request.mutable_evaluate() = request_with_pairs(random() % 5, random);
    const auto buffer = buffer_of(mutated(request.SerializeAsString(), random), 1 + random() % 40);
    const auto decoded = decode<StreamRequest>(buffer);
    if (decoded.ok() && decoded->request.ok()) touch(*decoded->request);
    const auto response = decode<StreamResponse>(buffer);
    if (response.ok() && std::holds_alternative<Response>(response->result)) {
      const auto& found = std::get<Response>(response->result);
      if (!found.is_f64) elements<float>(found.bytes, found.values);
    }
  }
}

TEST(Fuzz, RandomBytesDoNotCrash) {
  const google::protobuf::LogSilencer silent;
  std::mt19937 random(40'000);
  for (int round = 0; round < 10'000; ++round) {
    std::string bytes(random() % 64, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    const auto decoded = decode<Request>(buffer_of(bytes, 1 + random() % 9));
    EXPECT_EQ(is_legal(decoded), v1::EvaluateRequest().ParseFromString(bytes));
  }
}

}  // namespace
}  // namespace gonio::wire::testing
