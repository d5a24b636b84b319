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
import collections
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
LONGEST_SECONDS = 300
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
        streams = {"exit status": b"did not end"}
    for name, content in streams.items():
        (folder / name).write_bytes(content)
    files = sorted(path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    return {path.relative_to(folder).as_posix(): masked(path, folder) for path in files}


def differences(case, number, folder, binaries, servers):
    """The names of what differs. Keeps the folders of a case that does."""
    found, places = [], {side: folder / side / str(number) for side in binaries}
    made = {side: results(places[side], case, binaries[side], case.server and servers.address(side)) for side in binaries}
    for name in sorted(set(made["old"]) | set(made["new"])):
        if made["old"].get(name) != made["new"].get(name):
            found.append(name)
    if not found:
        for place in places.values():
            shutil.rmtree(place)
    return found, made["old"].get("exit status"), len(made["old"])


def compare(all_cases, folder, binaries, servers):
    """Runs all cases and prints the groups in order; returns the number of differing cases."""
    same, failing, outputs, differing = (collections.Counter() for _ in range(4))
    lines = collections.defaultdict(list)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        work = [pool.submit(differences, case, number, folder, binaries, servers) for number, case in enumerate(all_cases)]
        for number, (case, done) in enumerate(zip(all_cases, work)):
            found, status, count = done.result()
            same[case.group] += not found
            differing[case.group] += bool(found)
            failing[case.group] += status != b"0"
            outputs[case.group] += count
            if found:
                lines[case.group].append(f"    {case.name}: {', '.join(found)} (old/{number}, new/{number})")
    for group in dict.fromkeys(case.group for case in all_cases):
        print(f"{group:<10} {outputs[group]:>6} outputs of {same[group] + differing[group]:>4} commands, {failing[group]} of which fail: "
              f"{same[group]} the same, {differing[group]} differ")
        print("".join(line + "\n" for line in lines[group][:SHOWN]), end="")
    return sum(differing.values())


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
    chosen = [case for case in [*cases.all_cases(models, tables, isas), *from_pages]
              if not given.groups or case.group in given.groups]
    if not chosen:
        sys.exit(f"no group of {given.groups}")
    with Servers(folder, binaries) as servers:
        differing = compare(chosen, folder, binaries, servers)
    print("\n".join(left_out))
    print(f"{differing} commands differ; they are kept in {folder}" if differing else "all the same")
    if not differing and not given.folder:
        shutil.rmtree(folder)
    sys.exit(1 if differing else 0)


if __name__ == "__main__":
    main()
