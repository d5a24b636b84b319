#!/usr/bin/env python3
"""Do the files exist that pages and comments name? tests/style/paths.py [ROOT]

ROOT is the repository, this one if not given. Looked at are:
  - relative links of Markdown pages, with their headings (`page.md#heading`)
  - paths in a page's code: what begins with a top-level folder, and what ends like a source file, which may be relative to
    the page, to the top or to an include path, or be the end of a longer path; `*` and `{a,b}` as in a shell
  - programs in a page, `build/bin/NAME`
  - paths that begin with a top-level folder in comments of C++, CMake, shell and Python
Names in capitals (NAME, FOLDER), and name.h, stand for something else and are passed over. Exit status 1 when anything is missing.
"""

import itertools
import os
import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
TOP = r"(?:src|proto|server|client|tests|docker|\.ci)/"
TOP_PATH = re.compile(r"(?<![\w./$-])" + TOP + r"[\w./*{},-]*[\w/*}]")
SOURCE = re.compile(r"(?<![\w./$-])[\w./*{},-]+\.(?:(?:h|cpp)\.in|h|cpp|cmake|sh|py|proto|md)(?![\w/])")
OWN_TEST = "paths_test.py"  # its strings name what is missing
PROGRAM = re.compile(r"(?<![\w./-])build/bin/(\w+)")
COMMENT = re.compile(r"(?:^|\s)(?://|#)\s(.*)$")
STANDS_FOR = re.compile(r"(?<![a-z])(?!README)[A-Z]{3,}(?![a-z])|/name\.h$")
COMMENTED = (".h", ".cpp", ".cmake", ".sh", ".py", ".txt")


def expanded(path):
    """`a/{b,c}.h` as `a/b.h`, `a/c.h`."""
    parts = [part[1:-1].split(",") if part.startswith("{") else [part] for part in re.split(r"(\{[^}]*\})", path)]
    return ["".join(choice) for choice in itertools.product(*parts)]


def listed(root):
    """All files and folders of the repository, relative to it."""
    for folder, folders, files in os.walk(root):
        folders[:] = [name for name in folders if name not in (".git", "build", "out", "__pycache__")]
        for name in files + folders:
            yield pathlib.Path(folder, name).relative_to(root)


class Tree:
    def __init__(self, root):
        self.root = root
        self.paths = sorted(listed(root))
        self.texts = {path: (root / path).read_text(encoding="utf-8", errors="replace")
                      for path in self.paths if path.suffix in COMMENTED + (".md",) and (root / path).is_file()}
        cmake = "".join(text for path, text in self.texts.items() if path.name == "CMakeLists.txt")
        self.programs = set(re.findall(r"(?:add_executable|gonio_test)\(\s*(\w+)", cmake))

    def has(self, name, page=None):
        """Is there a file or folder of this name, or with this end?"""
        beside = [page.parent / name] if page else []
        exact = any((self.root / place).exists() for place in beside + [pathlib.Path(name)])
        return exact or any(path.match(name.rstrip("/")) for path in self.paths)


def headings(text):
    for line in re.findall(r"^#+ (.*)$", text, re.MULTILINE):
        yield re.sub(r"[^\w -]", "", line.lower()).replace(" ", "-")


def missing_links(tree, page, text):
    for link in LINK.findall(text):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, heading = link.partition("#")
        target = (tree.root / page.parent / name).resolve() if name else tree.root / page
        if not target.exists():
            yield link
        elif heading and heading not in headings(target.read_text(encoding="utf-8")):
            yield link


def missing_paths(tree, page, text):
    blocks = "\n".join(re.findall(r"^```.*?^```", text, re.MULTILINE | re.DOTALL))
    spans = "\n".join(CODE.findall(re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)))
    for name in sorted(set(TOP_PATH.findall(blocks + "\n" + spans) + SOURCE.findall(spans))):
        if not STANDS_FOR.search(name) and not all(tree.has(path, page) for path in expanded(name)):
            yield name
    yield from (f"build/bin/{name}" for name in set(PROGRAM.findall(text)) if name not in tree.programs)


def missing_in_comments(tree, text):
    for line in text.splitlines():
        if comment := COMMENT.search(line):
            for name in TOP_PATH.findall(comment[1]):
                if not STANDS_FOR.search(name) and not all(tree.has(path) for path in expanded(name)):
                    yield name


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    tree = Tree(root)
    problems = []
    for path, text in tree.texts.items():
        if path.suffix == ".md":
            missing = [*missing_links(tree, path, text), *missing_paths(tree, path, text)]
        else:
            missing = [] if path.name == OWN_TEST else missing_in_comments(tree, text)
        problems += [f"{path}: {name}" for name in missing]
    print("\n".join([f"not there: {problem}" for problem in problems] + [f"{len(tree.texts)} files, {len(problems)} names missing"]))
    sys.exit(1 if problems or not tree.texts else 0)


if __name__ == "__main__":
    main()
