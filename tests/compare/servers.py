"""A goniod of each build, with the same materials."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

STARTS_WITHIN = 20  # seconds


class Servers:
    def __init__(self, folder, binaries):
        self.sockets = pathlib.Path(tempfile.mkdtemp(prefix="gonio-"))  # a socket's path has little room
        self.processes = {}
        materials = folder / "inputs" / "served"
        materials.mkdir()
        (materials / "gloss.binary").symlink_to(folder / "inputs" / "gloss.binary")
        (materials / "red.json").write_text(json.dumps({"model": "lambertian", "parameters": {"rd": [0.5, 0.1, 0.1]}}))
        (materials / "wrong.json").write_text(json.dumps({"model": "lambertian", "parameters": {"rd": 2}}))
        environment = {name: value for name, value in os.environ.items() if name != "GONIO_SERVER"}
        for side, place in binaries.items():
            log = open(folder / f"{side}-goniod.log", "wb")
            self.processes[side] = subprocess.Popen([place / "goniod", "--listen", self.address(side), "--materials", materials],
                                                    stdout=log, stderr=log, env=environment)

    def address(self, side):
        return f"unix:{self.sockets}/{side}"

    def __enter__(self):
        until = time.monotonic() + STARTS_WITHIN
        while not all((self.sockets / side).exists() for side in self.processes):
            if time.monotonic() > until or any(process.poll() is not None for process in self.processes.values()):
                self.__exit__()
                raise SystemExit("goniod did not start; see its log beside the inputs")
            time.sleep(0.05)
        return self

    def __exit__(self, *_):
        for process in self.processes.values():
            process.terminate()
        for process in self.processes.values():
            process.wait()
        shutil.rmtree(self.sockets)
