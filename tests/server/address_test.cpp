#include "server/address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

#include "measured/temp_folder.h"
#include "server/harness.h"

namespace gonio::testing {
namespace {

using ::testing::HasSubstr;

TEST(Address, Forms) {
  EXPECT_EQ(parse_address("localhost:80")->host, "localhost");
  EXPECT_EQ(parse_address("0.0.0.0:0")->port, "0");
  EXPECT_EQ(parse_address("[::1]:50051")->host, "::1");
  EXPECT_EQ(parse_address("unix:/tmp/x")->path, "/tmp/x");
  EXPECT_EQ(parse_address("unix:///tmp/x")->path, "/tmp/x");
}

TEST(Address, BadOnesAreRefused) {
  for (const char* text :
       {"", "80", ":80", "host", "host:", "host:x", "host:65536", "host:-1", "host:80:90", "::1:80",
        "[]:80", "unix:", "http://host:80", "host:80 "}) {
    const auto address = parse_address(text);
    ASSERT_FALSE(address.ok()) << text;
    EXPECT_EQ(address.error().field, "listen");
    EXPECT_THAT(address.error().message, HasSubstr(text));
  }
  EXPECT_FALSE(parse_address("unix:/" + std::string(200, 'x')).ok());
}

ServerOptions listening_on(const std::string& address) {
  ServerOptions options;
  options.addresses = {address};
  return options;
}

TEST(Address, APortInUseIsSaidSo) {
  const TestServer first(listening_on("127.0.0.1:0"));
  const std::string taken = "127.0.0.1:" + std::to_string(first.server->port());
  const auto second = Server::start(listening_on(taken));
  ASSERT_FALSE(second.ok());
  EXPECT_THAT(second.error().message,
              HasSubstr("cannot listen on " + taken + ": Address already in use"));
  const auto wildcard =
      Server::start(listening_on("0.0.0.0:" + std::to_string(first.server->port())));
  EXPECT_FALSE(wildcard.ok());
}

// 192.0.2.1 belongs to no one (RFC 5737), so to no interface of this machine.
TEST(Address, AHostThatIsNotThisOneIsSaidSo) {
  const auto server = Server::start(listening_on("192.0.2.1:0"));
  ASSERT_FALSE(server.ok());
  EXPECT_THAT(server.error().message, HasSubstr("cannot listen on 192.0.2.1:0: "));
}

TEST(Address, ASocketInUseIsNotTakenOver) {
  const TempFolder folder;
  const std::string address = "unix:" + (folder / "s").string();
  const TestServer first(listening_on(address));
  const auto second = Server::start(listening_on(address));
  ASSERT_FALSE(second.ok());
  EXPECT_THAT(second.error().message, HasSubstr("another server"));
  // The first one still answers there.
  const auto stub =
      v1::GonioService::NewStub(grpc::CreateChannel(address, grpc::InsecureChannelCredentials()));
  grpc::ClientContext context;
  v1::ListModelsResponse response;
  EXPECT_TRUE(stub->ListModels(&context, {}, &response).ok());
}

TEST(Address, AStaleSocketIsReplacedAndOneOfOursRemoved) {
  const TempFolder folder;
  const std::string path = (folder / "s").string();
  sockaddr_un where{};
  where.sun_family = AF_UNIX;
  std::strcpy(where.sun_path, path.c_str());
  const int dead = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(dead, reinterpret_cast<const sockaddr*>(&where), sizeof where), 0);
  close(dead);
  ASSERT_TRUE(std::filesystem::exists(path));
  {
    const TestServer server(listening_on("unix:" + path));
    EXPECT_TRUE(std::filesystem::exists(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(Address, AFileThatIsNoSocketIsKept) {
  const TempFolder folder;
  const auto path = folder / "precious";
  std::ofstream(path) << "data";
  const auto server = Server::start(listening_on("unix:" + path.string()));
  ASSERT_FALSE(server.ok());
  EXPECT_THAT(server.error().message, HasSubstr("not a socket"));
  EXPECT_EQ(std::filesystem::file_size(path), 4U);
}

TEST(Address, AFolderThatDoesNotExistIsSaidSo) {
  const auto server = Server::start(listening_on("unix:/no/such/folder/s"));
  ASSERT_FALSE(server.ok());
  EXPECT_THAT(server.error().message, HasSubstr("/no/such/folder"));
}

TEST(Address, SeveralAtOnce) {
  const TempFolder folder;
  ServerOptions options;
  options.addresses = {"127.0.0.1:0", "unix:" + (folder / "s").string()};
  const TestServer server(options);
  for (const std::string& target :
       {"127.0.0.1:" + std::to_string(server.server->port()), options.addresses[1]}) {
    const auto stub =
        v1::GonioService::NewStub(grpc::CreateChannel(target, grpc::InsecureChannelCredentials()));
    grpc::ClientContext context;
    v1::ListModelsResponse response;
    EXPECT_TRUE(stub->ListModels(&context, {}, &response).ok()) << target;
  }
}

}  // namespace
}  // namespace gonio::testing
