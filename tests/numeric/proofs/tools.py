"""Sollya and Gappa, and how errors add up. Bounds are fractions, rounded outwards where they are printed."""
import re
import subprocess
from fractions import Fraction

from source import Failure, exact

AND = " /\\ "
FLOAT32, FLOAT64 = "float<ieee_32,ne>", "float<ieee_64,ne>"
U32, U64 = Fraction(1, 2**24), Fraction(1, 2**53)  # what one rounding takes, relatively


def run(program, text):
    try:
        done = subprocess.run([program, "/dev/stdin"] if program == "sollya" else [program], input=text, text=True,
                              capture_output=True, timeout=120, check=False)
    except FileNotFoundError:
        raise Failure(f"{program} is not installed; docker/install.sh --test installs it") from None
    except subprocess.TimeoutExpired:
        raise Failure(f"{program} took more than two minutes") from None
    return done.stdout + done.stderr


def sollya(expression):
    """An upper bound of a non-negative expression."""
    text = run("sollya", f"prec = 200!; display = powers!; print(round({expression}, 40, RU));\n").strip()
    found = re.fullmatch(r"(\d+)(?: \* 2\^\((-?\d+)\))?", text)
    if not found:
        raise Failure(f"Sollya does not bound {expression[:200]}: {text[:300]}")
    return Fraction(int(found.group(1))) * Fraction(2) ** int(found.group(2) or 0)


def supnorm(coefficients, function, low, high, mode="relative", step=1, first=0):
    """The certified largest error of c[0] x^first + c[1] x^(first + step) + ... against the function."""
    terms = " + ".join(f"{exact(c)} * x^{first + step * i}" for i, c in enumerate(coefficients))
    return sollya(f"sup(supnorm({terms}, {function}, [{low};{high}], {mode}, 2^-12))")


def number(x):
    """A float64 constant for Gappa, without rounding."""
    return f"({x.hex()})" if isinstance(x, float) else f"({x})"


def horner(name, x, exact_x, coefficients, rounding, fused):
    """polynomial() of numeric/elementary.h: name0 as computed of x, and exact_name0 the same without rounding, of exact_x."""
    last = len(coefficients) - 1
    lines = [f"{name}{last} = {number(coefficients[last])};", f"exact_{name}{last} = {number(coefficients[last])};"]
    for i in range(last - 1, -1, -1):
        c = number(coefficients[i])
        lines.append(f"{name}{i} = {rounding}({name}{i + 1} * {x} + {c});" if fused else
                     f"{name}{i} {rounding}= {name}{i + 1} * {x} + {c};")
        lines.append(f"exact_{name}{i} = exact_{name}{i + 1} * {exact_x} + {c};")
    return "\n".join(lines)


def gappa(definitions, hypotheses, *goals, hints=""):
    """The proved bounds of the goals' sizes, one or a list: of each the larger end of the interval that Gappa proves."""
    text = f"{definitions}\n{{ {hypotheses} -> {AND.join(goal + ' in ?' for goal in goals)} }}\n{hints}\n"
    output = run("gappa", text)
    end = r"(-?\d+(?:b-?\d+)?)(?: \{[^}]*\})?"
    proved = re.findall(rf" in \[{end}, {end}\]", output.partition("Results:")[2])
    if len(proved) != len(goals):
        raise Failure(f"Gappa does not prove {', '.join(goals)}:\n{output[:2000]}\n{text[-1500:]}")
    bounds = [max(abs(dyadic(end)) for end in ends) for ends in proved]
    return bounds[0] if len(goals) == 1 else bounds


def dyadic(text):
    """Gappa's mantissa b exponent."""
    mantissa, _, exponent = text.partition("b")
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent or 0)


def together(*errors):
    """Relative errors of factors, as one of the product."""
    product = Fraction(1)
    for error in errors:
        product *= 1 + error
    return product - 1


def upward(x, bits=40):
    """At least x, as Gappa reads the end of an interval."""
    x = Fraction(x)
    if x == 0:
        return "0"
    shift = bits - (x.numerator.bit_length() - x.denominator.bit_length())
    scaled = x * Fraction(2) ** shift
    return f"{-(-scaled.numerator // scaled.denominator)}b{-shift}"


def within(name, x):
    """The hypothesis |name| <= x."""
    return f"{name} in [-{upward(x)},{upward(x)}]" if x else f"{name} in [0,0]"
