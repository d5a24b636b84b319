#!/usr/bin/env python3
"""same_results.py finds a build the same as itself, and each way in which another one differs. compare_test.py BIN

BIN is the folder of the built programs.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from mask import masked  # noqa: E402

BIN = pathlib.Path(sys.argv.pop(1)).resolve()


def compared(new_gonio, group):
    """Output and exit status of a group's comparison with a build whose gonio is this script; None: with itself."""
    with tempfile.TemporaryDirectory() as folder:
        new = pathlib.Path(folder, "bin")
        new.mkdir()
        (new / "goniod").symlink_to(BIN / "goniod")
        if new_gonio is None:
            (new / "gonio").symlink_to(BIN / "gonio")
        else:
            (new / "gonio").write_text(f"#!/bin/bash\n{new_gonio.replace('GONIO', str(BIN / 'gonio'))}\n")
            (new / "gonio").chmod(0o755)
        environment = {name: value for name, value in os.environ.items() if name != "GONIO_DATA"}
        run = subprocess.run([sys.executable, HERE / "same_results.py", BIN, new, pathlib.Path(folder, "results"), "--groups",
                              group], env=environment, capture_output=True, text=True)
        return run.stdout + run.stderr, run.returncode


class SameResults(unittest.TestCase):
    def test_a_build_is_the_same_as_itself(self):
        output, status = compared(None, "lobe")
        self.assertEqual(status, 0, output)
        self.assertRegex(output, r"lobe +\d+ outputs of +\d+ commands, 0 of which fail: \d+ the same, 0 differ")
        self.assertIn("all the same", output)

    def test_finds_what_differs(self):
        for group, script, names in (
                ("mistakes", 'GONIO "$@" 2>error; s=$?; sed "s/allowed/permitted/" error >&2; rm error; exit $s', "stderr"),
                ("mistakes", 'GONIO "$@"; s=$?; [ $s = 2 ] && exit 1; exit $s', "exit status"),
                ("lobe", 'GONIO "$@"; printf x >> lobe.png; echo x > more.txt', "lobe.png, more.txt")):
            with self.subTest(names):
                output, status = compared(script, group)
                self.assertEqual(status, 1, output)
                self.assertRegex(output, rf": {names} \(old/\d+, new/\d+\)")
                self.assertNotIn("all the same", output)


class Mask(unittest.TestCase):
    def masked(self, name, text, chart=False):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, name)
            path.write_text(text)
            if chart:
                path.with_name("chart.json").write_text(text if name == "chart.json" else '{"tables": []}')
            return masked(path, pathlib.Path(folder)).decode()

    def test_leaves_times_out(self):
        for name, one, other in (
                ("stdout", "avx2, 0.25 s\n3.1 M pairs/s in 0.001 s", "avx2, 1e-3 s\n2 M pairs/s in 0.2 s"),
                ("stdout", "model  all    CPU s\nggx    0.2    0.0268", "model  all    CPU s\nggx    0.2    1.3"),
                ("a.md", "| model | CPU s |\n| ggx | 0.1 |", "| model | CPU s |\n| ggx | 0.3 |"),
                ("a.json", '{"kernel_seconds": 1e-5, "f": 1}', '{"kernel_seconds": 0.2, "f": 1}')):
            self.assertEqual(self.masked(name, one), self.masked(name, other))
        self.assertEqual(self.masked("a.csv", "model,ns,front\nggx,1,0", True), self.masked("a.csv", "model,ns,front\nggx,2,1", True))

    def test_leaves_results(self):
        for name, one, other in (
                ("stdout", "0.25 sr", "0.26 sr"), ("a.json", '{"f": 1}', '{"f": 2}'), ("a.csv", "ns\n1", "ns\n2"),
                ("stdout", "model  all    CPU s\nggx    0.2    0.1", "model  all    CPU s\nggx    0.3    0.1"),
                ("stdout", "CPU s\n0.1\n\n0.2", "CPU s\n0.1\n\n0.3"),
                ("a.md", "| model | L1 | CPU s |\n| ggx | 1 | 0.1 |", "| model | L1 | CPU s |\n| ggx | 2 | 0.1 |")):
            self.assertNotEqual(self.masked(name, one), self.masked(name, other))
        self.assertNotEqual(self.masked("a.csv", "model,error\nggx,1", True), self.masked("a.csv", "model,error\nggx,2", True))

    def test_reads_a_chart(self):
        def chart(ns, error):
            return json.dumps({"machine": {}, "effort": {}, "tables": [{"rows": [{"ns": ns, "front": ns, "error_worst": error}]}]})
        self.assertEqual(self.masked("chart.json", chart(1, 2), True), self.masked("chart.json", chart(3, 2), True))
        self.assertNotEqual(self.masked("chart.json", chart(1, 2), True), self.masked("chart.json", chart(1, 3), True))


if __name__ == "__main__":
    unittest.main()
