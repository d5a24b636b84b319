// goniod at its start: ports and sockets that are taken or left behind, files that cannot be used.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "measured/temp_folder.h"
#include "server/support/goniod.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Goniod, APortInUseIsAClearErrorAndANonZeroExit) {
  Daemon first({"--listen", "127.0.0.1:0"});
  const std::string taken = "127.0.0.1:" + std::to_string(first.port());
  const auto [code, output] = run({"--listen", taken});
  EXPECT_EQ(code, 1);
  EXPECT_THAT(output, AllOf(HasSubstr(taken), HasSubstr("in use")));
  EXPECT_TRUE(evaluate_at(taken).ok());
}

TEST(Goniod, ABadFileIsSkippedAndSaidSo) {
  const TempFolder folder;
  std::ofstream(folder / "gold.json") << R"({"model": "ggx"})";
  std::ofstream(folder / "rough.json") << R"({"model": "ggx", "parameters": {"alpha_x": 7}})";
  std::ofstream(folder / "cut.binary") << "12";
  Daemon daemon(
      {"--listen", "127.0.0.1:0", "--lame-duck", "0", "--materials", (folder / "").string()});
  EXPECT_THAT(daemon.line_with("not served: cut.binary"), HasSubstr(" warning "));
  EXPECT_THAT(daemon.line_with("not served: rough.json"), HasSubstr("alpha_x"));
  EXPECT_THAT(daemon.line_with("stored materials: 1"), HasSubstr("not served: 2"));
}

TEST(Goniod, ASocketHasItsMode) {
  const TempFolder folder;
  const std::string path = (folder / "s#1").string();
  Daemon daemon({"--listen", "unix:" + path, "--socket-mode", "0660", "--lame-duck", "0"});
  ASSERT_NE(daemon.line_with("stored materials"), "");
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0660));
  daemon.send(SIGTERM);
  EXPECT_EQ(daemon.wait_for_exit(), 0);
  EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

TEST(Goniod, AKilledServerLeavesASocketThatTheNextOneReplaces) {
  const TempFolder folder;
  const std::string address = "unix:" + (folder / "s").string();
  {
    Daemon first({"--listen", address});
    ASSERT_NE(first.line_with("stored materials"), "");
    first.send(SIGKILL);
    EXPECT_EQ(first.wait_for_exit(), -SIGKILL);
  }
  Daemon second({"--listen", address});
  ASSERT_NE(second.line_with("stored materials"), "");
  EXPECT_TRUE(evaluate_at(address).ok());
}

}  // namespace
}  // namespace gonio::server::testing
