"""Materials of every model that a build lists, in every combination of its words, and sums of them."""

import itertools
import json
import subprocess

SETS = 4  # parameter sets of each combination: the defaults, and three that spread over the ranges
CHANNELS = (3, 3, 1, 7)  # of the colours in each set
GOLDEN = 0.6180339887498949  # multiples of it spread evenly


def models_of(gonio):
    text = subprocess.run([gonio, "models", "--json"], check=True, capture_output=True, text=True).stdout
    return json.loads(text)["models"]


def word_choices(model):
    """Every combination of the words of a model's parameters."""
    worded = [p for p in model["parameters"] if p["words"]]
    for words in itertools.product(*([w for w in p["words"]] for p in worded)):
        yield {p["name"]: word for p, word in zip(worded, words)}


def used(parameter, words):
    other = parameter["used_with"]
    return not other or words.get(other) in parameter["used_with_words"]


def spread(parameter, place):
    """A value of the parameter's range, place in [0, 1)."""
    lower, upper = parameter["lower"], parameter["upper"]
    if parameter["logarithmic"]:
        lower = max(lower, upper * 1e-8)
        return lower * (upper / lower) ** (0.1 + 0.7 * place)
    if upper > 10:  # a multiplier, an index: where materials are
        lower, upper = max(lower, 0.2), 5
    return lower + (upper - lower) * place


def parameters_of(model, words, number):
    """The number-th parameter set of a model with these words."""
    values = dict(words)
    for at, parameter in enumerate(model["parameters"], 1):
        if number == 0 or parameter["words"] or not used(parameter, words):
            continue
        count = CHANNELS[number] if parameter["colour"] else 1
        places = [((7 * number + 3 * at + channel) * GOLDEN) % 1 for channel in range(count)]
        numbers = [spread(parameter, place) for place in places]
        values[parameter["name"]] = numbers if parameter["colour"] else numbers[0]
    return {"model": model["name"], "parameters": values}


def label(lobe, number):
    words = [value for value in lobe["parameters"].values() if isinstance(value, str)]
    return ":".join([lobe["model"], *words]) + f" {number}"


def singles(models, numbers=range(SETS)):
    """(label, material) of each model alone."""
    for model in models:
        if model["role"] != "MODEL_ROLE_MEASURED":
            for words in word_choices(model):
                for number in numbers:
                    lobe = parameters_of(model, words, number)
                    yield label(lobe, number), lobe


def sums(models):
    """(label, material): each specular lobe turned and over each diffuse base; four lobes; half of the lobes over one base."""
    of_role = {role: [m for m in models if m["role"] == f"MODEL_ROLE_{role}"] for role in ("DIFFUSE", "SPECULAR")}
    lobes = [parameters_of(m, next(word_choices(m)), 1) for m in of_role["SPECULAR"]]
    # A lobe of a sum has no diffuse part of its own.
    lobes = [{**lobe, "parameters": {k: v for k, v in lobe["parameters"].items() if k != "rd"}} for lobe in lobes]
    bases = [parameters_of(m, next(word_choices(m)), 1) for m in of_role["DIFFUSE"]]
    for lobe in lobes:
        yield f"{lobe['model']} turned", {**lobe, "rotation": -37.5}
        for base in bases:
            yield f"{base['model']} + {lobe['model']}", {"diffuse": base, "specular": [lobe]}
    yield "four lobes", {"diffuse": bases[0], "specular": lobes[:4], "rotation": 20}
    yield "four other lobes", {"specular": lobes[-4:]}
