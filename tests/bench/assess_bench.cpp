// How often assessments of good materials fail for the choice of their samples alone.
//
//   assess_bench alarms [SEEDS]   the eight measured materials that fits are judged by and every
//                                 model of the registry, each with SEEDS seeds (200)
//
// Only what depends on a seed is done again: what is integrated is kept, and the places of the
// catalogue, whose bounds hold for every pair, are left out. Exit status 1 if more than 1 % fail.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string_view>

#include "assess/alarms.h"

namespace {

int usage() {
  std::fputs("usage: assess_bench alarms [SEEDS]\n", stderr);
  return 2;
}

unsigned long long number(std::uint64_t n) { return n; }

int print_alarms(std::uint64_t seeds) {
  std::uint64_t failed = 0, all = 0;
  auto materials = gonio::testing::good_tables();
  if (materials.empty()) std::fputs("assess_bench: no measured materials in $GONIO_DATA\n", stderr);
  std::ranges::move(gonio::testing::good_models(), std::back_inserter(materials));
  for (const auto& good : materials) {
    const auto alarms = gonio::testing::alarms_of(good.make(), seeds);
    std::printf(
        "%-22s %4llu of %llu failed (distribution %llu, sampled_albedo %llu, others %llu); "
        "least probability %.1e, largest deviation %.2f\n",
        good.name.c_str(), number(alarms.failed), number(seeds), number(alarms.distribution),
        number(alarms.sampled_albedo), number(alarms.others), alarms.least_probability,
        alarms.largest_deviation);
    std::fflush(stdout);
    failed += alarms.failed, all += seeds;
  }
  const double rate = 100. * static_cast<double>(failed) / static_cast<double>(all);
  std::printf("%llu of %llu assessments failed: %.2f %%\n", number(failed), number(all), rate);
  return rate <= 1 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3 || std::string_view(argv[1]) != "alarms") return usage();
  const long long seeds = argc == 3 ? std::atoll(argv[2]) : 200;
  return seeds < 1 ? usage() : print_alarms(static_cast<std::uint64_t>(seeds));
}
