#include "wire/address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gonio::wire {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string target_of(const std::string& text) {
  const auto address = parse_address(text, "listen", 0);
  EXPECT_TRUE(address.ok()) << text;
  return address ? grpc_target(*address) : "";
}

TEST(Address, Forms) {
  EXPECT_EQ(parse_address("localhost:80", "", 0)->host, "localhost");
  EXPECT_EQ(parse_address("0.0.0.0:0", "", 0)->port, "0");
  EXPECT_EQ(parse_address("[::1]:50051", "", 0)->host, "::1");
  EXPECT_EQ(parse_address("unix:/tmp/x", "", 0)->path, "/tmp/x");
  EXPECT_EQ(parse_address("unix:///tmp/x", "", 0)->path, "/tmp/x");
  EXPECT_EQ(parse_address("unix:////tmp/x", "", 0)->path, "/tmp/x");
  EXPECT_EQ(parse_address("unix:x y", "", 0)->path, "x y");
}

TEST(Address, APathIsTheFilesNameByteByByte) {
  EXPECT_EQ(target_of("unix:/tmp/gonio-1.sock"), "unix:/tmp/gonio-1.sock");
  EXPECT_EQ(target_of("unix:a#b"), "unix:a%23b");
  EXPECT_EQ(target_of("unix:a%41b"), "unix:a%2541b");
  EXPECT_EQ(target_of("unix:a?b c"), "unix:a%3Fb%20c");
  EXPECT_EQ(target_of("unix:\xC3\xA9\xFF\n"), "unix:%C3%A9%FF%0A");
}

TEST(Address, AHostIsNoScheme) {
  EXPECT_EQ(target_of("dns:80"), "dns:///dns:80");
  EXPECT_EQ(target_of("[::1]:80"), "dns:///%5B::1%5D:80");
}

TEST(Address, BadOnesAreRefusedByName) {
  for (const char* text : {"",
                           "80",
                           ":80",
                           "host",
                           "host:",
                           "host:x",
                           "host:65536",
                           "host:-1",
                           "host:80:90",
                           "::1:80",
                           "[]:80",
                           "[a/b]:80",
                           "unix:",
                           "unix://x",
                           "unix://host/x",
                           "unix-abstract:80",
                           "http://h:80",
                           "host:80 ",
                           "a b:80",
                           "a\nb:80"}) {
    const auto address = parse_address(text, "listen", 0);
    ASSERT_FALSE(address.ok()) << text;
    EXPECT_EQ(address.error().field, "listen");
    EXPECT_THAT(address.error().message, AllOf(HasSubstr("listen is"), HasSubstr("host:port")));
  }
  EXPECT_FALSE(parse_address("host:0", "address", 1).ok());
  EXPECT_FALSE(parse_address(std::string_view("unix:a\0b", 8), "listen", 0).ok());
}

TEST(Address, APathHasTheLengthOfASocketsName) {
  EXPECT_TRUE(parse_address("unix:/" + std::string(106, 'x'), "listen", 0).ok());
  EXPECT_TRUE(parse_address("unix:///" + std::string(106, 'x'), "listen", 0).ok());
  const auto longer = parse_address("unix:/" + std::string(107, 'x'), "listen", 0);
  ASSERT_FALSE(longer.ok());
  EXPECT_THAT(longer.error().allowed, AllOf(HasSubstr("at most 107 bytes"), HasSubstr("108")));
}

}  // namespace
}  // namespace gonio::wire
