#!/usr/bin/env python3
"""Do `gonio chart` and the benchmarks, run apart, measure the same?

  tests/bench/agree.py [BIN]      BIN: the folder of the built programs, build/bin if not given

Prints the time of each evaluation and each sample by both, and their ratio; fails where one is off
by more than a fifth. Takes about a minute.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

ALLOWED = 0.2


def bench_times(program, names, folder):
    """Nanoseconds an item, the best repetition, by the benchmark's name."""
    out = folder / "bench.json"
    subprocess.run([program, f"--benchmark_filter={names}", f"--benchmark_out={out}", "--benchmark_out_format=json"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    times = {}
    for run in json.loads(out.read_text())["benchmarks"]:
        if run["run_type"] == "iteration":
            ns = 1e9 / run["items_per_second"]
            times[run["run_name"]] = min(ns, times.get(run["run_name"], ns))
    return times


def chart_rows(gonio, part, folder):
    subprocess.run([gonio, "chart", "--quiet", "--parts", part, "-o", folder], check=True)
    with open(folder / f"{part}.csv", newline="") as file:
        return list(csv.DictReader(file))


def bench_name_of_model(row):
    if row["instruction_set"] == "scalar":
        return f"{row['model']}/scalar {row['precision']}"
    return f"{row['model']}/{row['precision']}/{row['instruction_set']}/4096"


def bench_name_of_sampling(row, best):
    return f"{row['model']}/" + {"gonio": f"{best}/4096", "textbook": "scalar float"}.get(row["strategy"], "")


def compare(title, pairs):
    print(f"{title:<44} {'bench':>8} {'chart':>8} {'ratio':>6}")
    for name, bench, chart in pairs:
        print(f"{name:<44} {bench:8.2f} {chart:8.2f} {chart / bench:6.3f}")
    ratios = [chart / bench for _, bench, chart in pairs]
    print(f"{len(ratios)} of them: {min(ratios):.3f} to {max(ratios):.3f}\n")
    return all(abs(ratio - 1) <= ALLOWED for ratio in ratios)


def main():
    binaries = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else
                            pathlib.Path(__file__).resolve().parents[2] / "build" / "bin")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        times = bench_times(binaries / "core_bench", "/4096$|/scalar", folder)
        rows = chart_rows(binaries / "gonio", "models", folder)
        agree = compare("ns an evaluation", [(bench_name_of_model(row), times[bench_name_of_model(row)], float(row["ns"]))
                                             for row in rows])
        best = json.loads((folder / "chart.json").read_text())["machine"]["instruction_sets"][-1]
        times = bench_times(binaries / "sampling_bench", f"/{best}/4096$|/scalar", folder)
        rows = [row for row in chart_rows(binaries / "gonio", "sampling", folder)
                if row["strategy"] != "cosine" and row["theta"] == "30"]
        agree &= compare("ns a sample", [(bench_name_of_sampling(row, best), times[bench_name_of_sampling(row, best)],
                                          float(row["ns"])) for row in rows])
    sys.exit(0 if agree else "they do not agree within a fifth")


main()
