// What the tests of `gonio select` share.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cli/support/run_process.h"
#include "select/prices.h"

namespace gonio::test {

inline constexpr const char* kGrey =
    R"({"model": "lambertian", "parameters": {"rd": [0.5, 0.4, 0.3]}})";
inline constexpr const char* kGloss =
    R"({"diffuse": {"model": "lambertian", "parameters": {"rd": 0.4}}, "specular": [{"model": "ggx", "parameters": {"alpha_x": 0.3, "alpha_y": 0.3, "eta": 1.5}}]})";

// Scenes, materials and prices in a folder; `gonio select` within it.
class SelectCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string prices;
    for (const auto& [part, ns] : gonio::testing::prices_of_all_parts())
      prices += (prices.empty() ? "{\"" : ", \"") + part + "\": " + std::to_string(ns);
    write("costs.json", prices + ", \"reference\": 40}");
    write("scene.json",
          R"({"theta_i": [0, 60], "theta_o": [0, 75], "tolerance": 0.6, "anisotropy": false})");
    write("grey.json", kGrey);
    write("gloss.json", kGloss);
  }
  void write(const std::string& name, const std::string& content) {
    write_file(folder_ / name, content);
  }
  Finished select(const std::string& arguments) {
    return shell("cd '" + (folder_ / "").string() +
                 "' && gonio select --costs costs.json --lobes 1 " + arguments);
  }

  gonio::testing::TempFolder folder_;
};

}  // namespace gonio::test
