#!/usr/bin/env python3
"""Do `gonio chart` and the benchmarks, run apart, measure the same?

  tests/bench/agree.py [BIN]      BIN: the folder of the built programs, build/bin if not given

Prints the time of each evaluation, sample and call by both, and their ratio; fails where one is off
by more than a fifth. Each is run twice, in turn, and the better counts: where a process's memory happens to lie moves what is
bound by memory by a third. Takes some minutes.
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


def wire_times(program, folder):
    """Microseconds of a call of one pair, and of a stream of 1 M, the best."""
    out = folder / "wire.json"
    subprocess.run([program, "--benchmark_filter=unix", f"--benchmark_out={out}", "--benchmark_out_format=json"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    times = {}
    for run in json.loads(out.read_text())["benchmarks"]:
        if "best_us" in run:
            times["unary, 1 pair"] = run["best_us"]
        elif "/1048576/" in run["name"]:
            times["stream, 1 M pairs"] = 1e6 * (1 << 20) / run["best_pairs/s"]
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


def models(binaries, folder):
    times = bench_times(binaries / "core_bench", "/4096$|/scalar", folder)
    rows = chart_rows(binaries / "gonio", "models", folder)
    return [(bench_name_of_model(row), times[bench_name_of_model(row)], float(row["ns"])) for row in rows]


def samples(binaries, folder):
    rows = [row for row in chart_rows(binaries / "gonio", "sampling", folder)
            if row["strategy"] != "cosine" and row["theta"] == "30"]
    best = json.loads((folder / "chart.json").read_text())["machine"]["instruction_sets"][-1]
    times = bench_times(binaries / "sampling_bench", f"/{best}/4096$|/scalar", folder)
    names = [bench_name_of_sampling(row, best) for row in rows]
    return [(name, times[name], float(row["ns"])) for name, row in zip(names, rows)]


def calls(binaries, folder):
    times = wire_times(binaries / "wire_bench", folder)
    rows = [row for row in chart_rows(binaries / "gonio", "wire", folder)
            if row["form"] == "pairs" and row["pairs"] in ("1", "1048576") and row["chunk"] == "65536"]
    return [(name, times[name], float(row["us"])) for name, row in zip(("unary, 1 pair", "stream, 1 M pairs"), rows)]


def better_of_two(measure, binaries, folder):
    first, second = measure(binaries, folder), measure(binaries, folder)
    return [(name, min(a, c), min(b, d)) for (name, a, b), (_, c, d) in zip(first, second)]


def main():
    binaries = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else
                            pathlib.Path(__file__).resolve().parents[2] / "build" / "bin")
    agree = True
    with tempfile.TemporaryDirectory() as name:
        for title, measure in (("ns an evaluation", models), ("ns a sample", samples), ("us over a UNIX socket", calls)):
            agree &= compare(title, better_of_two(measure, binaries, pathlib.Path(name)))
    sys.exit(0 if agree else "they do not agree within a fifth")


main()
