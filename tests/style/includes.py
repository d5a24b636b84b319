#!/usr/bin/env python3
"""Do includes keep to the direction of dependencies? tests/style/includes.py [ROOT] [--arrows]

ROOT is the repository, this one if not given; --arrows prints which folders include which, with the number of includes.
Reported, with exit status 1:
  - an include that ALLOWED below does not have, and a folder that it does not know
  - files that include one another in a circle
  - a quoted include that names no file of the project
  - gRPC, protobuf, messages of the wire or a log in src/ or in a public header
  - a public header that includes one that is not installed
"""

import argparse
import collections
import graphlib
import pathlib
import re
import sys

# What each folder may include, besides its own files: the folders named here, and what these may include. The longest prefix
# of a file's path decides. src/README.md draws the same.
ALLOWED = {
    # Public headers.
    "src/include/gonio/base": [],
    "src/include/gonio/models": ["src/include/gonio/base"],
    "src/include/gonio/measured": ["src/include/gonio/base"],
    "src/include/gonio/engine": ["src/include/gonio/models", "src/include/gonio/measured"],
    # What fits, assessments, selections and charts find: plain values that the core, the wire and the client share.
    "src/include/gonio/fit": [],
    "src/include/gonio/assess": ["src/include/gonio/base"],
    "src/include/gonio/select": [],
    "src/include/gonio/chart": [],
    "client/include/gonio/client": ["src/include/gonio/base", "src/include/gonio/fit", "src/include/gonio/assess",
                                    "src/include/gonio/select", "src/include/gonio/chart"],
    # The core.
    "src/base": ["src/include/gonio/base"],
    "src/numeric": ["src/base"],
    "src/schema": ["src/numeric", "src/include/gonio/models"],
    "src/parts": ["src/schema"],
    "src/models": ["src/parts"],
    "src/kernels": ["src/parts", "src/include/gonio/engine"],
    "src/measured": ["src/kernels", "src/include/gonio/measured"],
    "src/engine": ["src/models", "src/kernels", "src/measured", "src/include/gonio/engine"],
    "src/timing": ["src/engine"],
    "src/assess": ["src/engine", "src/include/gonio/assess"],
    "src/fit": ["src/engine", "src/include/gonio/fit"],
    "src/select": ["src/fit", "src/timing", "src/include/gonio/select"],
    "src/chart": ["src/fit", "src/assess", "src/timing", "src/include/gonio/chart"],
    # The wire and its two ends. The client library sees nothing of the core but what the wire's headers need.
    "proto/wire": ["src/base", "src/include/gonio/engine", "src/include/gonio/fit", "src/include/gonio/assess",
                   "src/include/gonio/select", "src/include/gonio/chart"],
    "client": ["proto/wire", "client/include/gonio/client"],
    "server/arguments": ["src/base"],
    "server": ["proto/wire", "server/arguments", "src/select", "src/chart"],
    # The command line, which has the server in its own process where none is named.
    "client/picture": ["client/include/gonio/client", "src/base"],
    "client/cli": ["client/picture", "client", "server"],
}
PUBLIC = ("src/include/", "client/include/")
INCLUDE_PATHS = ("", "src", "src/include", "client/include", "proto", "tests")
GENERATED = re.compile(r"gonio/v1/\w+(\.grpc)?\.pb\.h|gonio/base/version\.h")
WIRE = re.compile(r"(grpc|grpcpp|google|spdlog|gonio/v1)/|.*\.pb\.h$")
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+)[>"]')


def closure(folder):
    found, todo = set(), [folder]
    while todo:
        at = todo.pop()
        if at not in found:
            found.add(at)
            todo += ALLOWED[at]
    return found


def row_of(path):
    """The row of ALLOWED that a file belongs to, or None."""
    rows = [row for row in ALLOWED if path.startswith(row + "/")]
    return max(rows, key=len, default=None)


def includes_of(root, file):
    """Of each include: its line, whether it is quoted, its text, and the project's file that it names or None."""
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        if match := INCLUDE.match(line):
            name = match[2]
            places = [root / place / name for place in INCLUDE_PATHS] + [file.parent / name]
            target = next((place for place in places if place.is_file()), None)
            yield number, match[1] == '"', name, target and target.resolve().relative_to(root).as_posix()


def forbidden_of(path, quoted, name, target):
    """What is wrong with one include, or None."""
    public = path.startswith(PUBLIC)
    if (path.startswith("src/") or public) and WIRE.match(name):
        return "the core and public headers must not know the wire or a log"
    if target is None:
        known = not quoted or GENERATED.fullmatch(name)
        return None if known else "no file of the project has this name"
    if public and not target.startswith(PUBLIC):
        return "a public header includes one that is not installed"
    own, other = row_of(path), row_of(target)
    if other is None:
        return "its folder has no row in the table of tests/style/includes.py"
    return None if other in closure(own) else f"{own}/ may not include {other}/"


def circle_in(graph):
    """Files that include one another, the first of them again at the end; empty if there are none."""
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as error:
        return list(reversed(error.args[1]))
    return []


def sources(root):
    for top in ("src", "proto", "server", "client"):
        yield from sorted(file for file in (root / top).rglob("*") if file.name.endswith((".h", ".cpp", ".h.in")))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", nargs="?", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--arrows", action="store_true")
    arguments = parser.parse_args()
    root = arguments.root.resolve()
    problems, graph, arrows, files = [], {}, collections.Counter(), 0
    for file in sources(root):
        files += 1
        path = file.relative_to(root).as_posix()
        if row_of(path) is None:
            problems.append(f"{path}: its folder has no row in the table of tests/style/includes.py")
            continue
        for line, quoted, name, target in includes_of(root, file):
            if reason := forbidden_of(path, quoted, name, target):
                problems.append(f"{path}:{line}: {name}: {reason}")
            elif target:
                graph.setdefault(path, []).append(target)
                arrows[(str(pathlib.PurePath(path).parent), str(pathlib.PurePath(target).parent))] += 1
    if circle := circle_in({row: below for row, below in ALLOWED.items()}):
        problems.append("the table itself has a circle: " + " -> ".join(circle))
    if circle := circle_in(graph):
        problems.append("a circle of includes: " + " -> ".join(circle))
    if arguments.arrows:
        print("\n".join(f"{a} -> {b}: {n}" for (a, b), n in sorted(arrows.items()) if a != b))
    print("\n".join(problems + [f"{files} files, {sum(arrows.values())} includes between them, {len(problems)} not allowed"]))
    sys.exit(1 if problems or not files else 0)


if __name__ == "__main__":
    main()
