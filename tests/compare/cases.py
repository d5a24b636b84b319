"""The compared commands, in groups. A case is run in a folder of its own beside inputs/; its command line goes through bash."""

import dataclasses
import itertools
import json
import os
import pathlib
import shlex

from materials import singles, sums

PRECISIONS = ("fast", "reference")
IN = "../../inputs/"


@dataclasses.dataclass(frozen=True)
class Case:
    group: str
    name: str
    command: str  # where $LISTEN is the address of a server, if the case has one
    server: bool = False


def quoted(material):
    return shlex.quote(json.dumps(material))


def evaluations(named, isas):
    for (name, material), precision, isa in itertools.product(named, PRECISIONS, isas):
        yield Case("evaluate", f"{name} {precision} {isa}",
                   f"gonio evaluate -m {material} --precision {precision} --isa {isa} --pairs {IN}pairs.csv --pdf")


def grids(named):
    for name, material in named:
        yield Case("grid", name, f"gonio evaluate -m {material} --deg --grid theta_h=0:88:12,theta_d=0:85:9,phi_d=0:180:7 -v -o x.npy;"
                                 f" gonio evaluate -m {material} --precision reference --with-input --grid theta_i=0.3,theta_o=0:1.5:9")


def samples(named, isas):
    for at, ((name, material), precision, isa) in enumerate(itertools.product(named, PRECISIONS, isas)):
        sequence = ("random", "sobol")[at % 2]
        yield Case("sample", f"{name} {precision} {isa} {sequence}",
                   f"gonio sample -m {material} --precision {precision} --isa {isa} --wi-file {IN}wi.csv --count 40 --seed {at}"
                   f" --sequence {sequence} --with-input")


def albedos(named):
    for name, material in named:
        yield Case("albedo", name, f"gonio albedo -m {material} --theta 0,30,60,85 --phi 20 --count 4096 --json; "
                                   f"gonio albedo -m {material} --theta 45 --count 4096 --precision reference")


def assessments(named, isas):
    for (name, material), isa in itertools.product(named, isas):
        yield Case("assess", f"{name} {isa}", f"gonio assess -m {material} --isa {isa} --pairs 1000 -v --report report.json")


def fits(tables):
    made = ("gonio evaluate -m '{\"diffuse\": {\"model\": \"lambertian\"}, \"specular\": [{\"model\": \"ggx\", \"parameters\": "
            "{\"alpha_x\": 0.1, \"alpha_y\": 0.3, \"f0\": [0.9, 0.5, 0.2]}}], \"rotation\": 25}' --deg --with-input "
            "--grid theta_i=5:75:5,theta_o=0:80:9,phi_o=0:340:18 -o data.csv; gonio fit --data data.csv --deg")
    options = ["--model all", "--model ggx,ward --anisotropic", "--model ggx:none,ward --lobes 2",
               "--model ashikhmin_shirley,phong --base none --polish", "--model blinn_phong --base oren_nayar --starts 3 --seed 5",
               "--model cook_torrance:conductor --strategy staged", "--model ggx --anisotropic --rotation 25",
               *(f"--model ggx,phong_mix:schlick --objective {objective}" for objective in ("l1", "l2", "huber", "log", "cbrt")),
               "--model lambertian,oren_nayar --max-theta 60", "--model ward --min-theta 50"]
    for option in options:
        yield Case("fit", option, f"{made} {option} -o material.json --report report.json --report report.md")
    for table in tables[:3]:
        yield Case("fit", table, f"gonio fit --data {IN}{table}.binary --model ggx:schlick,ward --max-theta 80 -o material.json"
                                 " --report report.json --report report.md")
    data = os.environ.get("GONIO_DATA")
    for name in ("cornell/garnet_red.brdf", "retro/retro-gray-tape.dat", "rgl/paper_white_rgb.bsdf"):
        if data and (file := pathlib.Path(data, name)).is_file():
            yield Case("fit", name, f"gonio fit --data {file} --model blinn_phong,oren_nayar -o - --report report.json")


def selections(tables):
    for table, scene, more in itertools.zip_longest(tables[:2], ("scene", "sky_scene"), ("--all", "--lobes 1"), fillvalue="gloss"):
        yield Case("select", f"{table} {scene}", f"gonio select --reference {IN}{table}.binary --scene {IN}{scene}.json"
                                                 f" --costs {IN}costs.json {more} -o choice.json --report report.json")


def charts(tables):
    yield Case("chart", "all parts", "gonio chart --quick -o chart")
    if len(tables) > 1:
        yield Case("chart", tables[1], f"gonio chart --quick --data {IN}{tables[1]}.binary --parts fits,resolution -o chart")


def pictures(named, tables):
    for name, material in named:
        yield Case("lobe", name, f"gonio lobe -m {material} --theta 30,75 --phi 40 -o lobe.png")
        yield Case("render", name, f"gonio render -m {material} --light sky --shape cylinder --size 64x48 --spp 8 -o a.png;"
                                   f" gonio render -m {material} --size 48x48 --spp 4 --sampling surface -q -o b.exr")
    first, second = named[0][1], named[1][1]
    yield Case("compare", "table", f"gonio compare --reference {IN}{tables[-1]}.binary -m {first} -m {second} --report report.json"
                                   " --slices slices.png --render spheres.png")
    yield Case("compare", "pairs", f"gonio evaluate -m {first} --deg --with-input --grid theta_i=5:75:5,theta_o=0:80:9,phi_o=0:340:18"
                                   f" -o data.csv; gonio compare --reference data.csv --deg -m {second} --report - --slices slices.png")


def words(models):
    commands = ["models", "evaluate", "sample", "albedo", "lobe", "render", "fit", "compare", "put", "assess", "select", "chart",
                "completion", "man"]
    yield Case("words", "--help", "gonio --help; goniod --help; gonio --version; goniod --version")
    for command in commands:
        yield Case("words", f"{command} --help", f"gonio {command} --help")
    for option in ("", "--json", "--presets", "--markdown", "--presets --json", *(model["name"] for model in models)):
        yield Case("words", f"models {option}", f"gonio models {option}")
    yield Case("words", "man, completion", "gonio man; gonio man fit; goniod man; for s in bash zsh fish; do gonio completion $s; done")


def mistakes():
    material = '{"model": "ggx", "parameters": {%s}}'
    for text in ('"f0": 2', '"alpha": 0.2', '"alpha_x": "gold"', '"f0": "bronze"', '"f0": [1, 2]', '"f0": true', '"fresnel": "x"',
                 '"eta": 1.5, "f0": 0.1', '"s": 1e400', '"f0": [0.1, 0.2], "scale": [1, 1, 1]', '"k": 1'):
        yield Case("mistakes", text, f"gonio evaluate -m {shlex.quote(material % text)} --grid theta_i=0.1")
    for text in ('{"model": "gxx"}', '{"model": "measured"}', '{"name": "lost"}', '{"model": "ggx", "rotation": 400}', '{"diffuse": {}}',
                 '{"specular": [{"model": "lambertian"}]}', '{"model": "ggx", "diffuse": {"model": "lambertian"}}', '[1]', '{', 'lost.json',
                 '{"model": "measured", "parameters": {"file": "lost.binary"}}', '{"model": "measured", "parameters": {"f": 1}}'):
        yield Case("mistakes", text, f"gonio evaluate -m {shlex.quote(text)} --grid theta_i=0.1")
    for text in ("evaluate -m copper", "evaluate -m copper --grid theta=1", "evaluate -m copper --isa sse --grid theta_i=0",
                 "sample -m copper --wi 0,0,2 --count 1", "fit --data lost.csv --model ggx", f"fit --data {IN}pairs.csv --model ggx",
                 "select --scene lost.json", "assess -m copper --max-gain x", "chart -o chart --parts lost", "fit --data x --model gxx",
                 f"select --scene {IN}wrong_scene.json", "lobe -m copper --theta 91 -o x.png", "render -m copper -o x.gif", "modles"):
        yield Case("mistakes", text, f"gonio {text}")


def served(named):
    """Through a server of the same build."""
    for name, material in named:
        common = f"-m {material} --server $LISTEN"
        yield Case("server", name, f"gonio evaluate {common} --pairs {IN}pairs.csv --pdf; gonio sample {common} --wi-file {IN}wi.csv"
                                   f" --count 9; gonio assess {common} --pairs 500 --json -; gonio albedo {common} --theta 30 --json;"
                                   f" gonio render {common} --size 32x32 --spp 4 -q -o a.png", server=True)
    yield Case("server", "models", "gonio models --server $LISTEN --json; gonio evaluate --server $LISTEN -m lost --grid theta_i=0",
               server=True)
    yield Case("server", "fit, select", f"gonio fit --server $LISTEN --data gloss --model ggx:schlick -o material.json --report report.json;"
                                        f" gonio select --server $LISTEN --reference gloss --scene {IN}scene.json --costs {IN}costs.json"
                                        " --lobes 1 -o choice.json --report choice_report.json; "
                                        "gonio chart --server $LISTEN --quick --parts approximations -o chart", server=True)


def tables_named(tables):
    for table, way in itertools.product(tables, ("linear", "nearest")):
        lookup = {"model": "measured", "parameters": {"file": f"{IN}{table}.binary", "interpolation": way}}
        yield f"{table} {way}", quoted(lookup)


def all_cases(models, tables, isas):
    def named(pairs):
        return [(name, quoted(material)) for name, material in pairs]
    every = named(singles(models)) + named(sums(models)) + list(tables_named(tables))
    first = named(singles(models, [1]))
    few = named(singles(models, [0]))[::4] + named(sums(models))[:4] + list(tables_named(tables))[:2]
    yield from words(models)
    yield from mistakes()
    yield from evaluations(every, isas)
    yield from grids(every)
    yield from samples(every, isas)
    yield from albedos(every)
    yield from assessments(first, isas)
    yield from assessments(named(sums(models))[-2:] + list(tables_named(tables))[:2], isas[-1:])
    yield from fits(tables)
    yield from selections(tables)
    yield from pictures(few, tables)
    yield from served(few[:-2])
    yield from charts(tables)
