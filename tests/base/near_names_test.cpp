#include "base/near_names.h"

#include <gtest/gtest.h>

#include <vector>

namespace gonio {
namespace {

const std::vector<std::string> kNames = {"aluminium", "brushed-metal", "copper", "gold",
                                         "old-gold",  "paper",         "silver"};

TEST(NearNames, ListsWhatIsAlikeBestFirst) {
  EXPECT_EQ(near_names("glod", kNames), "gold");
  EXPECT_EQ(near_names("Gold", kNames), "gold, old-gold");
  EXPECT_EQ(near_names("brushed", kNames), "brushed-metal");
  EXPECT_EQ(near_names("aluminum", kNames), "aluminium");
}

TEST(NearNames, ListsTheFirstWhereNothingIsAlike) {
  EXPECT_EQ(near_names("xyzzyx", kNames),
            "aluminium, brushed-metal, copper, gold, old-gold and 2 more");
  EXPECT_EQ(near_names("zzzzz", std::vector<std::string>{"gold"}), "gold");
  EXPECT_EQ(near_names("gold", std::vector<std::string>{}), "none");
}

TEST(NearNames, HugeNamesAreCutNotCompared) {
  EXPECT_EQ(near_names(std::string(10'000'000, 'g'), std::vector<std::string>{"gold"}), "gold");
}

}  // namespace
}  // namespace gonio
