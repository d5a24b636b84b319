#!/usr/bin/env python3
"""paths.py reports names of files that are not there, and nothing else."""

import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import small_tree  # noqa: E402

FILES = {
    "README.md": "# Top\n[the map](src/README.md#how-it-runs) [site](https://example.org/x)\n",
    "src/README.md": "# Map\n## How it runs\n`engine/truth.h`, `src/engine/`, `src/*/truth.{h,cpp}`, `truth.h`, `src/engine/NAME.h`\n",
    "src/engine/truth.h": "// See src/README.md.\n",
    "src/engine/truth.cpp": '#include "src/lost.h"\n',
    "tests/CMakeLists.txt": "add_executable(core_bench core_bench.cpp)  # src/engine/truth.h is its own\n",
    "tests/README.md": "```sh\ntests/run.sh; build/bin/core_bench\n```\n",
    "tests/run.sh": "",
}


def check(changes):
    """The output and exit status of paths.py for the small tree with these files in addition or instead."""
    return small_tree.check("paths.py", {**FILES, **changes})


class Paths(unittest.TestCase):
    def test_passes_what_is_there(self):
        self.assertEqual(check({}), ("7 files, 0 names missing\n", 0))

    def test_reports_what_is_missing(self):
        for name, text, missing in (
                ("server/README.md", "[map](../src/LOST.md)\n", "../src/LOST.md"),
                ("server/README.md", "[map](../src/README.md#lost)\n", "../src/README.md#lost"),
                ("server/README.md", "`lost.h`\n", "lost.h"),
                ("server/README.md", "`engine/lost.cpp` \n", "engine/lost.cpp"),
                ("server/README.md", "`src/lost/`\n", "src/lost/"),
                ("server/README.md", "`src/engine/truth.{h,py}`\n", "src/engine/truth.{h,py}"),
                ("server/README.md", "```sh\ntests/lost.sh FOLDER\n```\n", "tests/lost.sh"),
                ("server/README.md", "`build/bin/lost_bench` says how much\n", "build/bin/lost_bench"),
                ("server/server.h", "int x;  // as src/engine/lost.h has it\n", "src/engine/lost.h"),
                ("server/CMakeLists.txt", "# tests/lost/ says why\n", "tests/lost/")):
            with self.subTest(text):
                self.assertEqual(check({name: text}), (f"not there: {name}: {missing}\n8 files, 1 names missing\n", 1))


if __name__ == "__main__":
    unittest.main()
