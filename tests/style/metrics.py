#!/usr/bin/env python3
"""Sizes of files and functions: tests/style/metrics.py [ROOT]

ROOT is the repository, this one if not given. Of the C++ of the product (src, proto, server, client) and of the tests it prints
how many files and functions there are, the median, the 90th percentile and the largest of their lines, the ten longest
functions, and folders with more than 25 files. Lines of a function go from its name's line to its closing brace; a lambda
counts with the function that holds it, a class or a table with none.
"""

import collections
import pathlib
import re
import sys

PARTS = {"product": ("src", "proto", "server", "client"), "tests": ("tests",)}
MOST_FILES = 25
STRING = r'R"(?P<raw>\w*)\(.*?\)(?P=raw)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''
COMMENT = r"//[^\n]*|/\*.*?\*/"
NO_CODE = re.compile(STRING + "|" + COMMENT, re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
DIGIT_SEPARATOR = re.compile(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])")
# What stands before the brace of something that is no function.
NO_FUNCTION = re.compile(r"\b(namespace|enum|union)\b|^\s*(template\s*<.*>\s*)?(class|struct)\b|=\s*$|=\s*\[", re.DOTALL)


def blank(text):
    """The text with comments and strings as spaces, and the preprocessor's lines too."""
    def keep_lines(match):
        return re.sub(r"[^\n]", " ", match[0])
    return DIRECTIVE.sub(keep_lines, NO_CODE.sub(keep_lines, DIGIT_SEPARATOR.sub("0", text)))


def functions_of(text):
    """(first line, last line, head) of each function that a file defines."""
    text = blank(text)
    open_braces, since = [], 0  # of each brace: is it a function's, and its head; where the current head begins
    for match in re.finditer(r"[{};]", text):
        at, sign = match.start(), match[0]
        inside = any(function for function, _, _ in open_braces)
        if sign == "{":
            head = text[since:at]
            # clang-format leaves no space before the braces of a member's value.
            is_function = (not inside and ")" in head and head[-1].isspace() and head.count("(") == head.count(")")
                           and not NO_FUNCTION.search(head))
            start = since + len(head) - len(head.lstrip())
            open_braces.append((is_function, text.count("\n", 0, start) + 1, " ".join(head.split())))
        elif sign == "}" and open_braces:
            function, first, head = open_braces.pop()
            if function:
                yield first, text.count("\n", 0, at) + 1, head
        since = at + 1


def percentile(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))]


def line(name, sizes):
    """sizes: of each thing its lines and where it is."""
    values = [size for size, _ in sizes]
    largest = max(sizes)
    return (f"{name:<20} {len(values):>6} {sum(values):>8} {percentile(values, 0.5):>7} {percentile(values, 0.9):>7} "
            f"{largest[0]:>8}  {largest[1]}")


def measure(root, folders):
    files, functions = [], []
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                text, name = path.read_text(encoding="utf-8"), path.relative_to(root).as_posix()
                files.append((text.count("\n"), name))
                for first, last, head in functions_of(text):
                    functions.append((last - first + 1, f"{name}:{first} {head[:60]}"))
    return files, functions


def crowded(root):
    counts = collections.Counter()
    for folders in PARTS.values():
        for folder in folders:
            counts.update(path.parent.relative_to(root).as_posix() for path in (root / folder).rglob("*")
                          if path.is_file() and "__pycache__" not in path.parts)
    return [(count, folder) for folder, count in counts.items() if count > MOST_FILES]


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    longest = []
    print(f"{'C++ lines':<20} {'number':>6} {'all':>8} {'median':>7} {'90 %':>7} {'largest':>8}")
    for name, folders in PARTS.items():
        files, functions = measure(root, folders)
        print(line(f"{name}: files", files))
        print(line(f"{name}: functions", functions))
        longest += functions
    print("\nthe longest functions:")
    for size, place in sorted(longest, reverse=True)[:10]:
        print(f"{size:>6}  {place}")
    print(f"\nfolders with more than {MOST_FILES} files: " +
          (", ".join(f"{folder} {count}" for count, folder in sorted(crowded(root), reverse=True)) or "none"))


if __name__ == "__main__":
    main()
