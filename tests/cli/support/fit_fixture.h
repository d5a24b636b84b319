// `gonio fit` with data whose material is known. Thread safety: one test at a time.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cli/support/run_process.h"
#include "data_folder.h"

namespace gonio::test {

inline const std::string kTruth =
    R"({"diffuse": {"model": "lambertian", "parameters": {"rd": [0.3, 0.1, 0.05]}},
        "specular": [{"model": "ggx", "parameters": {"f0": [0.3, 0.2, 0.1], "alpha_x": 0.15, "alpha_y": 0.15}}]})";

// Pairs of a known material, written by `gonio evaluate`, and a shell line with $D for their
// folder.
class FitCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    write_file(folder_ / "truth.json", kTruth);
    const auto made =
        run("gonio evaluate --material $D/truth.json --deg --with-input "
            "--grid theta_i=5:75:8,phi_i=0,theta_o=0:80:17,phi_o=0:350:36 -o $D/data.csv");
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }

  [[nodiscard]] Finished run(const std::string& line, const std::string& input = {}) const {
    return shell("D='" + (folder_ / "").string() + "'; " + line, input);
  }
  [[nodiscard]] std::string content(const std::string& name) const {
    return read_file(folder_ / name);
  }

  gonio::testing::TempFolder folder_;
};

}  // namespace gonio::test
