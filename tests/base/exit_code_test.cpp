#include "base/exit_code.h"

#include <gtest/gtest.h>

#include <array>

namespace gonio {
namespace {

TEST(ExitCode, SaysWhoseFaultItIs) {
  const auto code = [](ErrorCode of, const char* allowed = "") {
    return exit_code_of({of, "", "", "", allowed});
  };
  for (const ErrorCode wrong : {ErrorCode::invalid_argument, ErrorCode::not_found,
                                ErrorCode::already_exists, ErrorCode::data_loss})
    EXPECT_EQ(code(wrong), exit_bad_input);
  EXPECT_EQ(code(ErrorCode::resource_exhausted, "at most 5"), exit_bad_input);
  EXPECT_EQ(code(ErrorCode::resource_exhausted), exit_unreachable);
  EXPECT_EQ(code(ErrorCode::unavailable), exit_unreachable);
  EXPECT_EQ(code(ErrorCode::deadline_exceeded), exit_unreachable);
  EXPECT_EQ(code(ErrorCode::internal), exit_failed);
}

TEST(ExitCode, TextHasALineForEach) {
  EXPECT_EQ(exit_status_text(std::array{exit_ok, exit_failed}),
            "Exit status:\n  0  done\n  1  failed on the way");
}

}  // namespace
}  // namespace gonio
