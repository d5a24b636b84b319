"""The commands of the pages: blocks of shell that make results, one case a page, in the order in which a reader runs them."""

import pathlib
import re

from cases import IN, Case

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```sh\n(.*?)^```", re.MULTILINE | re.DOTALL)
# Blocks that build or install. A block with a server is left to the group `server`, which starts its own.
LEFT_OUT = re.compile(r"\b(docker/|tests/|cmake|protoc|goniod|/tmp/|localhost)")
# Times are kept short, choices kept free of times, and files are made rather than measured.
BEFORE = ("gonio() { case $1 in chart) command gonio \"$@\" --quick ;; select) command gonio \"$@\" --costs %scosts.json ;; "
          "render) command gonio \"$@\" --size 128x128 --spp 16 ;; *) command gonio \"$@\" ;; esac; }\n") % IN
TABLE = re.compile(r"[\w-]+\.binary")


def blocks_of(page):
    """The blocks of a page that are run, and how many are left out."""
    found = BLOCK.findall(page.read_text(encoding="utf-8"))
    run = [block for block in found if re.search(r"\bgonio ", block) and not LEFT_OUT.search(block)]
    return run, len(found) - len(run)


def page_cases(tables):
    """A case for each page that has such blocks, and lines that say what was left out."""
    cases, left_out = [], []
    material = next(block for block in blocks_of(ROOT / "README.md")[0] if "> gold.json" in block)
    gold = next(line for line in material.splitlines() if "> gold.json" in line)
    for page in sorted(ROOT.rglob("README.md")):
        name = page.relative_to(ROOT).as_posix()
        if name.startswith(("build/", "out/")):
            continue
        blocks, others = blocks_of(page)
        if others:
            left_out.append(f"{name}: {others} blocks of shell that build, serve or have no gonio in them are not run")
        needed = sorted({table for block in blocks for table in TABLE.findall(block) if f"> {table}" not in block})
        links = "".join(f"ln -s {IN}{table if table[:-7] in tables else 'gloss.binary'} {table}\n" for table in needed)
        if blocks:
            cases.append(Case("pages", name, BEFORE + links + gold + "\n" + "\n".join(blocks)))
    return cases, left_out
