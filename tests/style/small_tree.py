"""Runs a check of this folder on a small tree of files, for the tests of the checks."""

import pathlib
import subprocess
import sys
import tempfile


def check(script, files):
    """The output and exit status of a script for a tree of these files, texts by path."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            file = pathlib.Path(folder, name)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        run = subprocess.run([sys.executable, pathlib.Path(__file__).with_name(script), folder], capture_output=True, text=True)
        return run.stdout + run.stderr, run.returncode
