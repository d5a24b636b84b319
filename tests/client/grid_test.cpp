// Grids of angles through the client: the same bits in one call and in runs.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "client/support/server_fixture.h"
#include "gonio/client/client.h"

namespace gonio::test {
namespace {

using client::ClientOptions;

class GridTest : public ServerFixture {};

TEST_F(GridTest, GridIsTheSameInOneCallAndInRuns) {
  client::Grid grid;
  grid.theta_i = {0, 0.3, 1.2};
  grid.phi_i = {0, 2};
  grid.theta_o = {0.1, 0.5, 0.9, 1.5, 1.7};
  grid.phi_o = {0, 1, 2, 3, 4, 5, 6};
  const std::size_t pairs = 3 * 2 * 5 * 7;
  std::vector<float> expected(3 * pairs), values(3 * pairs);
  std::vector<std::uint8_t> expected_flags(pairs), flags(pairs);
  auto whole = connect("tcp").evaluate(ggx(), grid, expected, expected_flags);
  ASSERT_TRUE(whole.ok()) << whole.error().message;
  EXPECT_EQ(whole->pairs, pairs);
  EXPECT_GT(whole->flagged, 0U);
  for (const std::size_t chunk : {1U, 3U, 7U, 20U, 35U, 69U, 71U, 209U}) {
    ClientOptions options;
    options.chunk_pairs = chunk;
    auto report = connect("tcp", options).evaluate(ggx(), grid, values, flags);
    ASSERT_TRUE(report.ok()) << report.error().message;
    EXPECT_EQ(std::memcmp(values.data(), expected.data(), values.size() * sizeof(float)), 0)
        << chunk;
    EXPECT_EQ(flags, expected_flags) << chunk;
  }
  std::size_t seen = 0;
  const client::ChunkSink<double, double> sink = [&](const client::Chunk<double, double>& chunk) {
    EXPECT_TRUE(chunk.wi.empty());
    seen += chunk.pairs;
    return Ok{};
  };
  auto report = connect("tcp").evaluate_chunks<double>(ggx(), grid, sink);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(seen, pairs);
}

TEST_F(GridTest, HalfAngleGrid) {
  client::Grid grid;
  grid.theta_h = {0, 0.5};
  grid.theta_d = {0, 0.2, 0.4};
  grid.phi_d = {0, 1, 2, 3};
  std::vector<float> expected(3 * 24), values(3 * 24);
  ASSERT_TRUE(connect("tcp").evaluate(ggx(), grid, expected).ok());
  ClientOptions options;
  options.chunk_pairs = 5;
  ASSERT_TRUE(connect("tcp", options).evaluate(ggx(), grid, values).ok());
  EXPECT_EQ(values, expected);
}

}  // namespace
}  // namespace gonio::test
