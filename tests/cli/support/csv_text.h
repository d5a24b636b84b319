// CSV given to `gonio fit` and `gonio evaluate` on standard input. Thread safety: functions without
// state.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cli/support/run_process.h"

namespace gonio::test {

inline const std::string kEvaluate =
    R"(gonio evaluate --deg -m '{"model": "lambertian", "parameters": {"rd": 0.5}}' --pairs )";
inline const std::string kFit = "gonio fit --model lambertian --deg --data ";
inline const std::string kHeader = "theta_i,phi_i,theta_o,phi_o,f_0,flags\n";

inline std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// What a fit of this CSV says first: how many pairs it took.
inline std::string pairs_of(const std::string& csv) {
  const auto result = shell(kFit + "-", csv);
  return result.exit_code == 0 ? first_line(result.out) : result.err;
}

inline std::string error_of(const std::string& csv) {
  const auto result = shell(kFit + "-", csv);
  EXPECT_EQ(result.exit_code, 2) << csv;
  EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
  return result.err;
}

inline std::string rows(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += std::to_string(i % 80) + ",0," + std::to_string(i % 70) + ",180,0.25,0\n";
  return text;
}

}  // namespace gonio::test
