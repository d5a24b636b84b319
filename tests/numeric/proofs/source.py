"""What the proofs take from the sources: tables of coefficients, bounds, and the text of functions.

Nothing is copied by hand. A proof that transcribes a function names the digest of the text that it transcribes, so that a changed
function has no proof until somebody has looked at both.
"""
import hashlib
import math
import re
import struct
from fractions import Fraction
from pathlib import Path

ISAS = ("baseline", "avx2", "avx512")
ROOT = Path(__file__).resolve().parents[3]
NUMERIC = ROOT / "src" / "numeric"


class Failure(Exception):
    """A proof that does not hold, or cannot be tried; its text says why."""


def text_of(file):
    """The file without comments."""
    return re.sub(r"//[^\n]*", "", (NUMERIC / file).read_text())


def braced(text, start):
    """From `start` to the brace that closes the first one after it."""
    depth = 0
    for i in range(text.index("{", start), len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return text[start:i + 1]
    raise Failure("a brace is not closed")


def function(file, head):
    """The text of the one function whose definition begins with `head`."""
    text = text_of(file)
    found = [m.start() for m in re.finditer(re.escape(head), text)]
    if len(found) != 1:
        raise Failure(f"{file}: {len(found)} functions begin with '{head}'; the proofs expect one")
    return braced(text, found[0])


def digest(file, head):
    """Of a function's operations: its text without spaces and without its tables' numbers."""
    text = re.sub(r"=\s*\{[^;]*\};", "= {};", function(file, head))
    return hashlib.sha256(re.sub(r"\s+", "", text).encode()).hexdigest()[:12]


def expect(file, *heads):
    """Fails unless the functions are still those that the proofs were written for: transcribed.txt holds their digests."""
    known = dict(reversed(line.split(" ", 1)) for line in (Path(__file__).parent / "transcribed.txt").read_text().splitlines())
    for head in heads:
        found, name = digest(file, head), f"{file}: {' '.join(head.split())}"
        if known.get(name) != found:
            raise Failure(f"{name} ... is not what its proof transcribes: compare both, mend the proof, and let the line of "
                          f"transcribed.txt be\n{found} {name}")


def array(file, head, name):
    """A table of coefficients as the compiler makes it: float64, one operation at a time."""
    found = re.search(name + r"\[\]\s*=\s*\{([^}]*)\}", function(file, head))
    if not found:
        raise Failure(f"{file}: no table {name} in '{head}'")
    log2e = re.search(r"kLog2E = ([0-9.]+)", function(file, head))
    numbers = []
    for entry in found.group(1).split(","):
        entry = entry.strip()
        if not re.fullmatch(r"[-+*/. 0-9eA-Z_kLog]*", entry):
            raise Failure(f"{file}: {name} holds '{entry}', which the proofs cannot read")
        numbers.append(eval(entry, {"kLog2E": float(log2e.group(1)) if log2e else None}))  # float64 throughout
    return [float(x) for x in numbers]


def constant(file, head, pattern):
    """A number of a function, as the compiler rounds it to float64."""
    found = re.search(pattern, function(file, head))
    if not found:
        raise Failure(f"{file}: '{head}' has no {pattern}")
    return math.pi if found.group(1) == "std::numbers::pi" else float(found.group(1))


def float32(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def exact(x):
    """A number as Sollya and Gappa read it without rounding."""
    f = Fraction(x)
    return f"({f.numerator}/{f.denominator})" if f.denominator != 1 else f"({f.numerator})"


def stated():
    """The bounds of numeric/errors.h by name."""
    text = text_of("errors.h")
    bounds = {name: float(value) for name, value in re.findall(r"double (k\w+) = ([-0-9.e]+);", text)}
    if not bounds:
        raise Failure("errors.h states no bounds")
    return bounds
