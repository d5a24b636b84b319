// What goniod makes of its arguments: texts, clear errors, and exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "measured/temp_folder.h"
#include "server/support/goniod.h"

namespace gonio::server::testing {
namespace {

using gonio::testing::TempFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Goniod, BadArgumentsAreClearErrors) {
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{"--no-such-option"}, "--no-such-option"},
      {{"--materal", "x"}, "mean \"--materials\"?"},
      {{"--log-level", "warn"}, "mean \"warning\"?"},
      {{"--threads", "many"}, "--threads"},
      {{"--max-message-mb", "0"}, "--max-message-mb"},
      {{"--log-format", "xml"}, "--log-format"},
      {{"--log-level", "loud"}, "--log-level"},
      {{"--threads", "-3"}, "--threads"},
      {{"--max-queue", "0"}, "--max-queue"},
      {{"--memory-quota-mb", "8"}, "--memory-quota-mb"},
      {{"--grace", "nan"}, "--grace"},
      {{"--lame-duck", "nan"}, "--lame-duck"},
      {{"--longest-fit", "nan"}, "--longest-fit"},
      {{"--longest-fit", "0"}, "--longest-fit"},
      {{"--max-queue", "99999999999999999999"}, "--max-queue"},
      {{"--fit-threads", "0"}, "--fit-threads"},
      {{"--max-fits", "-1"}, "--max-fits"},
      {{"--put-quota-mb", "x"}, "--put-quota-mb"},
      {{"--listen", "unix:s", "--socket-mode", "rw"}, "--socket-mode"},
      {{"--listen", "unix:s", "--socket-mode", "0888"}, "--socket-mode"},
      {{"--listen", "unix:s", "--socket-mode", "0060"}, "0600 to 0777"},
      {{"--socket-mode", "0660"}, "--socket-mode"},
  };
  for (const auto& [arguments, what] : cases) {
    const auto [code, output] = run(arguments);
    EXPECT_EQ(code, 2);
    EXPECT_THAT(output, HasSubstr(what));
  }
}

TEST(Goniod, WhatCannotBeServedIsAClearError) {
  const TempFolder folder;
  std::ofstream(folder / "bad.json") << "{";
  const std::tuple<std::vector<std::string>, int, std::string> cases[] = {
      {{"--listen", "nonsense"}, 2, "nonsense"},
      {{"--listen", "unix://x"}, 2, "unix://x"},
      {{"--listen", "unix:/" + std::string(200, 'x')}, 2, "at most 107 bytes"},
      {{"--listen", "nonsense", "--log-level", "off"}, 2, "nonsense"},
      {{"--listen", "127.0.0.1:0", "--materials", "/no/such"}, 2, "/no/such"},
      {{"--listen", "127.0.0.1:0", "--check", "--materials", (folder / "").string()},
       2,
       "bad.json"},
  };
  for (const auto& [arguments, expected, what] : cases) {
    const auto [code, output] = run(arguments);
    EXPECT_EQ(code, expected) << what;
    EXPECT_THAT(output, HasSubstr(what));
  }
}

TEST(Goniod, CheckServesNothing) {
  const TempFolder folder;
  std::ofstream(folder / "gold.json") << R"({"model": "ggx"})";
  Daemon living({"--listen", "127.0.0.1:0"});
  const std::string taken = "127.0.0.1:" + std::to_string(living.port());
  const auto [code, output] =
      run({"--check", "--listen", taken, "--materials", (folder / "").string()});
  EXPECT_EQ(code, 0) << output;
  EXPECT_THAT(output, HasSubstr("stored materials: 1, not served: 0"));
}

TEST(Goniod, VersionAndHelp) {
  EXPECT_THAT(run({"--version"}), ::testing::Pair(0, HasSubstr("goniod 0.")));
  EXPECT_THAT(run({"--help"}),
              ::testing::Pair(0, AllOf(HasSubstr("--listen"), HasSubstr("--materials"))));
}

}  // namespace
}  // namespace gonio::server::testing
