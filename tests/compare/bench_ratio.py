#!/usr/bin/env python3
"""How much slower or faster is a build? tests/compare/bench_ratio.py OLD_BENCH NEW_BENCH [--filter REGEX] [--rounds N] [--limit X]

Runs two programs of Google Benchmark (core_bench, sampling_bench) in turn, the one that begins changing from round to
round, and compares the best time of each row: other work on the machine only adds time. Prints every row's ratio, the worst
last, and ends with 1 where one is above the limit in percent. FILTER chooses rows; without it, batches of 10000 pairs and
combinations of lobes and channels.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

# core_bench compares batches of 4096 with its oracle at the end, which takes longer than to time them.
ROWS = "/10000$|64 channels$|sum of"
FEWEST_ROUNDS = 9


def times(program, rows, seconds):
    """Nanoseconds an item, or an iteration, by row."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "bench.json")
        subprocess.run([program, f"--benchmark_filter={rows}", "--benchmark_repetitions=1", f"--benchmark_min_time={seconds}",
                        f"--benchmark_out={out}", "--benchmark_out_format=json"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        runs = json.loads(out.read_text())["benchmarks"]
    return {run["run_name"]: 1e9 / run["items_per_second"] if "items_per_second" in run else run["real_time"]
            for run in runs if run["run_type"] == "iteration"}


def best_times(programs, given):
    """By side, the best of all rounds of each row."""
    best = {side: {} for side in programs}
    for number in range(max(given.rounds, FEWEST_ROUNDS)):
        order = list(programs) if number % 2 == 0 else list(reversed(programs))
        for side in order:
            for row, ns in times(programs[side], given.filter, given.seconds).items():
                best[side][row] = min(ns, best[side].get(row, ns))
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=pathlib.Path)
    parser.add_argument("new", type=pathlib.Path)
    parser.add_argument("--filter", default=ROWS)
    parser.add_argument("--rounds", type=int, default=FEWEST_ROUNDS, help=f"{FEWEST_ROUNDS} or more")
    parser.add_argument("--seconds", type=float, default=0.02, help="the least time of a row in a round")
    parser.add_argument("--limit", type=float, default=3, help="percent that a row may be slower")
    given = parser.parse_args()
    best = best_times({"old": given.old.resolve(), "new": given.new.resolve()}, given)
    alone = set(best["old"]) ^ set(best["new"])
    rows = sorted((best["new"][row] / ns, row) for row, ns in best["old"].items() if row in best["new"])
    if not rows:
        sys.exit(f"no row of both is called like {given.filter}")
    print(f"{'ratio':>7} {'old ns':>9} {'new ns':>9}  row")
    for ratio, row in rows:
        print(f"{ratio:7.3f} {best['old'][row]:9.3f} {best['new'][row]:9.3f}  {row}")
    for row in sorted(alone):
        print(f"only in one of them: {row}")
    slower = sum(ratio > 1 + given.limit / 100 for ratio, _ in rows)
    print(f"{len(rows)} rows, median {rows[len(rows) // 2][0]:.3f}, worst {rows[-1][0]:.3f} ({rows[-1][1]}); "
          f"{slower} slower by more than {given.limit:g} %")
    sys.exit(1 if slower else 0)


if __name__ == "__main__":
    main()
