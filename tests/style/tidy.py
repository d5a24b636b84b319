#!/usr/bin/env python3
"""Runs clang-tidy over the product's sources (not the tests'): tests/style/tidy.py BUILD_DIR [FILE-PREFIX ...]

A file that passed is not checked again, in this checkout or another one of the same user, until it, a header of ours that it
includes, its compile command, .clang-tidy or clang-tidy itself changes; $XDG_CACHE_HOME/gonio-tidy (~/.cache/gonio-tidy)
remembers. BUILD_DIR must have been built: Ninja knows which header each source includes. Exit status 1 when anything is
reported.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Clang does not know all of GCC's warnings, and its -Wconversion says more than GCC's, which is the one that we keep.
EXTRA = [
    "--extra-arg=-Wno-unknown-warning-option",
    "--extra-arg=-Wno-ignored-optimization-argument",
    "--extra-arg=-Wno-unused-command-line-argument",
    "--extra-arg=-Wno-sign-conversion",
]
# The path-sensitive analysis pays in the core. Around it, gRPC's headers make it take as long as everything else together
# (its mistakes there are for the sanitizers), and so does the look for parameters that could be references; and the kernels have
# no paths to follow.
ANALYSED = "src/"
NOT_ANALYSED = {"src/kernels/common_kernels.cpp", "src/measured/merl/kernels.cpp", "src/fit/linear/array_kernels.cpp"}


def without_precompiled(command):
    """The compile command as if no header were precompiled: GCC's are not Clang's, and each source is to include what it uses."""
    words = shlex.split(command)
    of_header = {at + offset for at in range(len(words) - 1) for offset in (0, 1)
                 if words[at] == "-include" and words[at + 1].endswith("cmake_pch.hxx")}
    return shlex.join(word for at, word in enumerate(words) if at not in of_header and word != "-Winvalid-pch")


def commands(build, prefixes):
    """One compile command per source of ours (kernels are compiled several times; the first stands for all)."""
    first = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        entry["command"] = without_precompiled(entry["command"])
        source = pathlib.Path(entry["file"])
        if not source.is_relative_to(ROOT) or source.is_relative_to(ROOT / "build"):
            continue
        if source.is_relative_to(ROOT / "tests"):
            continue
        name = str(source.relative_to(ROOT))
        if not prefixes or name.startswith(tuple(prefixes)):
            first.setdefault(name, entry)
    return first


def object_of(entry):
    words = shlex.split(entry["command"])
    return words[words.index("-o") + 1]


def included_files(build):
    """What Ninja recorded: object file -> the files of ours, generated ones too, that went into it."""
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], check=True, capture_output=True, text=True).stdout
    found, current = {}, []
    for line in listing.splitlines():
        if line.startswith(" "):
            path = pathlib.Path(os.path.normpath(build / line.strip()))
            if path.is_relative_to(ROOT):
                current.append(path)
        elif ": #deps" in line:
            current = found.setdefault(line.split(": #deps")[0], [])
    return found


def key_of(entry, dependencies, version):
    """Changes when anything changes that could change clang-tidy's verdict; where the checkout lies could not."""
    command = entry["command"].replace(str(ROOT), "")
    digest = hashlib.sha256((version + command + " ".join(EXTRA)).encode())
    for path in [ROOT / ".clang-tidy", pathlib.Path(entry["file"]), *sorted(dependencies)]:
        digest.update(path.read_bytes())
    return digest.hexdigest()


def check(database, name):
    analysed = name.startswith(ANALYSED) and name not in NOT_ANALYSED
    checks = [] if analysed else ["--checks=-clang-analyzer-*,-performance-unnecessary-value-param"]
    command = ["clang-tidy", "--quiet", "-p", database, *checks, *EXTRA, str(ROOT / name)]
    run = subprocess.run(command, capture_output=True, text=True)
    return run.returncode == 0, run.stdout + ("" if run.stdout else run.stderr)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    sources = commands(build, sys.argv[2:])
    includes = included_files(build)
    version = subprocess.run(["clang-tidy", "--version"], check=True, capture_output=True, text=True).stdout
    cache = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "gonio-tidy"
    cache.mkdir(parents=True, exist_ok=True)
    keys = {name: key_of(entry, includes.get(object_of(entry), []), version) for name, entry in sources.items()}
    todo = [name for name in sorted(sources) if not (cache / keys[name]).exists()]
    print(f"clang-tidy: {len(todo)} of {len(sources)} files to check", flush=True)
    failed = 0
    with tempfile.TemporaryDirectory() as database, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        (pathlib.Path(database) / "compile_commands.json").write_text(json.dumps(list(sources.values())))
        for name, (passed, output) in zip(todo, pool.map(lambda name: check(database, name), todo)):
            if passed:
                (cache / keys[name]).touch()
            else:
                failed += 1
                print(f"--- {name}\n{output}", flush=True)
    print(f"clang-tidy: {len(sources) - failed} clean, {failed} not")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
