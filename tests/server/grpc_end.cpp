// gRPC ends on a thread of its own if one of its own threads held it last, and a test program that
// leaves in the middle of that leaves threads behind, which the thread sanitizer reports. Every
// test program with gRPC in it therefore holds the library from its first test to its last and then
// waits for its end.
#include <grpc/grpc.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace {

class GrpcUntilTheEnd : public testing::Environment {
 public:
  void SetUp() override { grpc_init(); }

  // gRPC counts who uses it, and says that nobody does only once all its threads are joined.
  void TearDown() override {
    using namespace std::chrono_literals;
    grpc_shutdown();
    const auto last = std::chrono::steady_clock::now() + 30s;
    while (grpc_is_initialized() != 0) {
      ASSERT_LT(std::chrono::steady_clock::now(), last) << "something of a test still uses gRPC";
      std::this_thread::sleep_for(1ms);
    }
  }
};

[[maybe_unused]] const testing::Environment* const registered =
    testing::AddGlobalTestEnvironment(new GrpcUntilTheEnd);

}  // namespace
