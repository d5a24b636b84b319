"""Files that the compared commands read: pairs, measurements, scenes, tables. Both builds get the same ones."""

import itertools
import json
import math
import os
import pathlib
import random
import subprocess

PAIRS = 2001
MEASURED = ("nickel", "red-fabric2", "violet-rubber")  # of $GONIO_DATA/merl


def direction(theta, phi):
    return math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)


def mirrored(d):
    return -d[0], -d[1], d[2]


def near(d, by, draw):
    """A direction beside d, above the horizon."""
    x, y, z = (c + by * draw.uniform(-1, 1) for c in d)
    length = math.sqrt(x * x + y * y + z * z)
    return x / length, y / length, abs(z) / length


def pairs():
    """Over the hemisphere, about the mirror, towards the light, grazing, and what is no direction."""
    draw = random.Random(14)
    for i in range(PAIRS):
        wi = direction(math.acos(draw.random()), draw.uniform(0, 2 * math.pi))
        kind, by = i % 6, 10 ** draw.uniform(-6, -0.5)
        wo = direction(math.acos(draw.random()), draw.uniform(0, 2 * math.pi))
        if kind == 1:
            wo = near(mirrored(wi), by, draw)
        elif kind == 2:
            wo = near(wi, by, draw)
        elif kind == 3:
            wi, wo = (direction(math.acos(min(1, by)), draw.uniform(0, 6)) for _ in range(2))
        elif kind == 4:
            wo = tuple(c * (1 + draw.uniform(-9e-4, 9e-4)) for c in wo)
        if i % 97 == 0:
            wo = draw.choice([(math.nan, 0, 1), (0, 0, 0), (0, 0, 2), mirrored(tuple(-c for c in wo)), (math.inf, 0, 1)])
        yield wi + wo


def write_csv(path, columns, rows):
    path.write_text("\n".join([columns] + [",".join(repr(c) for c in row) for row in rows]) + "\n")


def costs(models):
    """Nanoseconds of each part, so that a choice does not depend on a measured time: of models, with any of their words."""
    names = []
    for model in models:
        words = [["", *(":" + word for word in p["words"])] for p in model["parameters"] if p["words"]]
        names += [model["name"] + "".join(choice) for choice in itertools.product(*words)]
    return {name: round(1 + 0.37 * at, 2) for at, name in enumerate(sorted(names))}


def make(folder, bin_folder, models):
    """Writes all of them; returns the names of the tables."""
    folder.mkdir()
    write_csv(folder / "pairs.csv", "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z", pairs())
    write_csv(folder / "wi.csv", "theta_i,phi_i", [(0.2 * i, 1.3 * i) for i in range(8)] + [(1.5707, 0), (1.6, 0)])
    (folder / "costs.json").write_text(json.dumps(costs(models)))
    (folder / "scene.json").write_text(json.dumps({"theta_i": [0, 75], "theta_o": [0, 75], "tolerance": 0.1}))
    (folder / "wrong_scene.json").write_text(json.dumps({"tolerence": 0.1}))
    (folder / "sky_scene.json").write_text(json.dumps({"theta_o": [0, 60], "lights": "environment", "tolerance": 0.2,
                                                       "metric": "cbrt", "cost": "bytes"}))
    merl = pathlib.Path(os.environ.get("GONIO_DATA", "")) / "merl"
    names = list(MEASURED) if os.environ.get("GONIO_DATA") and merl.is_dir() else []
    for name in ["gloss", *names]:
        made = [bin_folder / "make_merl", folder / f"{name}.binary"] + ([name] if name in names else [])
        subprocess.run(made, check=True)
    return ["gloss", *names]
