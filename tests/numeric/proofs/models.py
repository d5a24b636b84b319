#!/usr/bin/env python3
"""How far the bounds of numeric/errors.h carry a whole model: fast values of lambertian, and of blinn_phong without a Fresnel term.

Prints what is proved beside what the model states; fails where the proof is not within that, or README.md says otherwise. Written as inequalities
of the steps in parts/geometry.h, parts/cosine_power.h and models/blinn_phong.h; errors are floats, rounded up at the end."""
import math
import re
import sys
from pathlib import Path

from source import ROOT, Failure, stated

U32, U64 = 2.0**-24, 2.0**-53
LEAST = 1e-30   # bounds are for values above
SCALE = 1e6     # the largest
LARGEST_S = 1e7


def error_of_half_vector():
    """Of H's tangential part, absolutely, for two directions within 1e-3 of unit length. |k|^2 - 1 is summed from parts below 1 with an
    error of U64 (float32 squares are exact), half of which the inverse length adds to its own error; both directions are
    multiplied by theirs, and rounded. The sum's own rounding is relative to H."""
    inverse = stated()["kInverseLengthError"] + 0.51 * U64
    return 2 * inverse + 2 * U64


def power_of_half_vector(s, least_hz):
    """Relative error of (n.h)^s, as far as values above LEAST need it. With T = tan^2, x = -s/2 log2(1 + T):

    - H's error in T is 2 |dH| / |H_xy|, and makes s |dH| sqrt(T) / (Hz (1 + T)) of the power. sqrt(T) is at most (2^(2 x / s) - 1)^(1/2),
      or (1 + T) / 2; that grows with s, as x does, so that the largest s has the largest error;
    - the logarithm's relative error and one rounding of the weight, times x log 2, and so the roundings of squares and of Hz."""
    norm = (s + 2) * (s + 4) / (8 * math.pi * s)
    x = math.log2(norm * SCALE / LEAST)
    tangent = math.sqrt(2.0 ** (2 * x / s) - 1)
    of_tangent = s * error_of_half_vector() / least_hz * min(tangent, 0.5)
    of_logarithm = x * math.log(2) * (stated()["kQuickWeightedLog2Error"] + 20 * U64)
    return (1 + 1e-5) * (of_tangent + of_logarithm)


def blinn_phong(s, least_hz):
    """The power, the amplitude's rounding to float32 and that of its product with the scale, rounded itself."""
    return power_of_half_vector(s, least_hz) + stated()["kTimesExp2Error"] + 3 * U32 + 1e-12


def lambertian():
    """rd / pi in float64, pi itself rounded, and rounded to float32."""
    return U32 + 3 * U64


def said(model):
    """The fast bound of a model's table."""
    text = (ROOT / "src" / "models" / f"{model}.h").read_text()
    return float(re.search(r"\.fast = \{\.relative = ([0-9.e-]+)", text).group(1))


def noted():
    """The numbers of parts/cosine_power.h's note: the bound in the corner, the exponent and the cosine where it begins."""
    text = (ROOT / "src" / "parts" / "cosine_power.h").read_text()
    note = re.search(r'kFastNote =\s*"([0-9e-]+) for exponents above ([0-9e]+) where both cosines are below ([0-9e-]+)"', text)
    if not note:
        raise Failure("parts/cosine_power.h's kFastNote is not what this proof reads")
    return [float(number) for number in note.groups()]


def main():
    corner, exponent, cosine = noted()
    rows = [("lambertian", lambertian(), said("lambertian")),
            (f"blinn_phong, s up to {exponent:g}", blinn_phong(exponent, 2e-6), said("blinn_phong")),
            # Where one cosine is above the note's, Hz is.
            (f"blinn_phong, a cosine above {cosine:g}", blinn_phong(LARGEST_S, cosine), said("blinn_phong")),
            ("blinn_phong, everywhere", blinn_phong(LARGEST_S, 2e-6), corner)]
    page = (Path(__file__).parent / "README.md").read_text()
    for name, proved, bound in rows:
        if proved > bound:
            raise Failure(f"{name}: {proved:.3g} is proved and {bound:.3g} stated")
        line = f"| {name} | {bound:.2g} | {proved:.2g} |"
        if line not in page:
            raise Failure(f"README.md should say\n{line}")
        print(line)


if __name__ == "__main__":
    try:
        main()
    except Failure as why:
        sys.exit(f"models.py: {why}")
