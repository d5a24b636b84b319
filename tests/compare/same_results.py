#!/usr/bin/env python3
"""Do two builds give the same results? tests/compare/same_results.py OLD_BIN NEW_BIN [FOLDER] [--groups GROUP,...]

OLD_BIN and NEW_BIN are folders with gonio and goniod (and make_merl in the first). Both run every command of the pages, and
all models with each combination of their words: values, densities, samples, albedos, assessments, fits, selections, charts,
pictures, on each instruction set of this processor, alone and through a server; also texts and error messages. What they
write, print and exit with is compared byte by byte, save for what mask.py lists. Where $GONIO_DATA is set, its tables are
among the materials. What differs is kept in FOLDER (a temporary one if not given), in old/ and new/.

Prints a line for each group (or only for those named), and each difference. Exit status 1 where there is one. Takes about three minutes on two cores.
"""

import argparse
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True

import cases  # noqa: E402
import inputs  # noqa: E402
import materials  # noqa: E402
import pages  # noqa: E402
from mask import masked  # noqa: E402
from servers import Servers  # noqa: E402

INSTRUCTION_SETS = ("baseline", "avx2", "avx512")
LONGEST_SECONDS = 600
UNENDED = b"did not end"  # is never the same
SHOWN = 20  # differences of a group


def supported(gonio):
    """The instruction sets that this processor has; the others are refused."""
    command = [gonio, "evaluate", "-m", '{"model": "lambertian"}', "--grid", "theta_i=0", "--isa"]
    return [isa for isa in INSTRUCTION_SETS if subprocess.run([*command, isa], capture_output=True).returncode == 0]


def results(folder, case, binaries, listen):
    """Of all that a case writes and prints: its name and what is compared of it."""
    folder.mkdir(parents=True)
    environment = {**os.environ, "PATH": f"{binaries}:{os.environ['PATH']}", "LISTEN": listen or ""}
    environment.pop("GONIO_SERVER", None)
    try:
        run = subprocess.run(["bash", "-c", case.command], cwd=folder, env=environment, capture_output=True,
                             stdin=subprocess.DEVNULL, timeout=LONGEST_SECONDS)
        streams = {"stdout": run.stdout, "stderr": run.stderr, "exit status": str(run.returncode).encode()}
    except subprocess.TimeoutExpired:
        streams = {"exit status": UNENDED}
    for name, content in streams.items():
        (folder / name).write_bytes(content)
    files = sorted(path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    return {path.relative_to(folder).as_posix(): masked(path, folder) for path in files}


def differences(case, number, folder, binaries, servers):
    """The names of what differs, the old exit status and the number of outputs. Keeps the folders of a case that differs."""
    found, places = [], {side: folder / side / str(number) for side in binaries}
    made = {side: results(places[side], case, binaries[side], case.server and servers.address(side)) for side in binaries}
    for name in sorted(set(made["old"]) | set(made["new"])):
        if made["old"].get(name) != made["new"].get(name) or made["old"][name] == UNENDED:
            found.append(name)
    if not found:
        for place in places.values():
            shutil.rmtree(place)
    return found, made["old"].get("exit status"), len(made["old"])


def group_line(name, done):
    """What is printed of a group, from the differences, exit statuses and numbers of outputs of its cases."""
    differing = sum(bool(found) for found, _, _ in done)
    return (f"{name:<10} {sum(count for _, _, count in done):>6} outputs of {len(done):>4} commands, "
            f"{sum(status != b'0' for _, status, _ in done)} of which fail: {len(done) - differing} the same, {differing} differ")


def compare(all_cases, folder, binaries, servers):
    """Runs all cases and prints the groups in order; returns the number of differing cases."""
    total, done, lines = 0, [], []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        work = [pool.submit(differences, case, number, folder, binaries, servers) for number, case in enumerate(all_cases)]
        for number, case in enumerate(all_cases):
            done.append(work[number].result())
            if found := done[-1][0]:
                total += 1
                lines.append(f"    {case.name}: {', '.join(found)} (old/{number}, new/{number})")
            if number + 1 == len(all_cases) or all_cases[number + 1].group != case.group:
                print("\n".join([group_line(case.group, done), *lines[:SHOWN]]), flush=True)
                done, lines = [], []
    return total


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=pathlib.Path)
    parser.add_argument("new", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path, nargs="?")
    parser.add_argument("--groups", type=lambda text: text.split(","))
    return parser.parse_args()


def main():
    given = arguments()
    binaries = {"old": given.old.resolve(), "new": given.new.resolve()}
    folder = (given.folder or pathlib.Path(tempfile.mkdtemp(prefix="gonio-compare-"))).resolve()
    for name in ("old", "new", "inputs"):
        shutil.rmtree(folder / name, ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)
    models = materials.models_of(binaries["old"] / "gonio")
    tables = inputs.make(folder / "inputs", binaries["old"], models)
    isas = supported(binaries["old"] / "gonio")
    print(f"instruction sets: {', '.join(isas)}; not on this processor: {', '.join(set(INSTRUCTION_SETS) - set(isas)) or 'none'}; "
          f"tables: {', '.join(tables)}", flush=True)
    from_pages, left_out = pages.page_cases(tables)
    every = [*cases.all_cases(models, tables, isas), *from_pages]
    chosen = sorted((case for case in every if not given.groups or case.group in given.groups), key=lambda case: case.group)
    if not chosen:
        sys.exit(f"no group of {given.groups}")
    with Servers(folder, binaries) as servers:
        differing = compare(chosen, folder, binaries, servers)
    if any(case.group == "pages" for case in chosen):
        print("\n".join(left_out))
    print(f"{differing} commands differ; they are kept in {folder}" if differing else "all the same")
    if not differing and not given.folder:
        shutil.rmtree(folder)
    sys.exit(1 if differing else 0)


if __name__ == "__main__":
    main()
