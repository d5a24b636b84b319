#include "server/address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

#include "gonio/client/client.h"
#include "measured/temp_folder.h"
#include "server/support/harness.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;
using ::testing::HasSubstr;

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

bool is_answered(const std::string& address) {
  const auto client = client::Client::connect(address);
  return client && client->list_models().ok();
}

// What gRPC itself would read as an escape, a query, a fragment or a host.
TEST(Address, ServerAndClientMeanTheSameFile) {
  const TempFolder folder;
  for (const char* name : {"plain", "a#b", "a%41b", "a%", "a?b=c", "a b", "gr\xC3\xA4y", "\xFF",
                           "a:b", "a&b;c", "100%25"}) {
    const std::string path = (folder / name).string();
    const TestServer server(listening_on("unix:" + path));
    EXPECT_TRUE(std::filesystem::is_socket(path)) << name;
    EXPECT_TRUE(is_answered("unix:" + path)) << name;
    EXPECT_TRUE(is_answered("unix://" + path)) << name;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

TEST(Address, ARelativePathIsOneOfTheWorkingFolder) {
  const TempFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  {
    const TestServer server(listening_on("unix:s"));
    EXPECT_TRUE(std::filesystem::is_socket(folder / "s"));
    EXPECT_TRUE(is_answered("unix:s"));
    EXPECT_TRUE(is_answered("unix:" + (folder / "s").string()));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "s"));
  std::filesystem::current_path(before);
}

TEST(Address, ThePathMayBeAsLongAsASocketsName) {
  const TempFolder folder;
  const std::string path =
      (folder / std::string(106 - (folder / "").string().size(), 'x')).string() + '#';
  ASSERT_EQ(path.size(), 107U);
  const TestServer server(listening_on("unix:" + path));
  EXPECT_TRUE(is_answered("unix:" + path));
}

TEST(Address, TcpInAllItsForms) {
  for (const char* host : {"localhost", "127.0.0.1", "[::1]"}) {
    const auto server = Server::start(listening_on(std::string(host) + ":0"));
    if (!server && host[0] == '[') continue;  // a machine without IPv6
    ASSERT_TRUE(server.ok()) << server.error().message;
    EXPECT_TRUE(is_answered(std::string(host) + ":" + std::to_string((*server)->port()))) << host;
  }
}

mode_t mode_of(const std::filesystem::path& path) {
  return static_cast<mode_t>(std::filesystem::status(path).permissions()) & 0777U;
}

TEST(Address, ASocketHasTheModeThatIsAskedFor) {
  const TempFolder folder;
  const std::string path = (folder / "s").string();
  const mode_t umask_before = ::umask(022);
  ServerOptions options = listening_on("unix:" + path);
  for (const unsigned mode : {0600U, 0660U, 0777U}) {
    options.socket_mode = mode;
    const TestServer server(options);
    EXPECT_EQ(mode_of(path), mode);
    std::ofstream(folder / "other") << "x";
    EXPECT_EQ(mode_of(folder / "other"), 0644U);
    std::filesystem::remove(folder / "other");
  }
  {
    const TestServer server(listening_on("unix:" + path));
    EXPECT_EQ(mode_of(path), 0755U);
  }
  ::umask(umask_before);
  for (const unsigned mode : {0U, 0060U, 0400U, 01777U}) {
    options.socket_mode = mode;
    const auto server = Server::start(options);
    ASSERT_FALSE(server.ok());
    EXPECT_EQ(server.error().field, "socket_mode");
  }
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
}  // namespace gonio::server::testing
