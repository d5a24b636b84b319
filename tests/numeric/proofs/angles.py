"""Angles of directions, and directions of angles."""
import math
from fractions import Fraction

from products import quick_division
from source import array, constant, exact, expect, float32
from tools import FLOAT32, FLOAT64, U64, gappa, horner, number, sollya, supnorm, within

ELEMENTARY, WARP = "elementary.h", "warp.h"
ANGLE = "GONIO_INLINE Double<E> first_quadrant_angle"
HALF_OF = "GONIO_INLINE Turn<T> half_turn_of"
HALF = "GONIO_INLINE Turn<T> half_turn(T x)"
HALF_FLOAT = "GONIO_INLINE Turn<Float> half_turn"
TURN = "GONIO_INLINE Turn<T> turn"
PI = r"(std::numbers::pi)"


def quadrant(fused, table_name, division):
    """Relative to the larger component the others are q = small / large in [0, 1]; z = (q - t) / (1 + t q)."""
    table = array(ELEMENTARY, ANGLE, table_name)
    approximation = supnorm(table, "atan(x)", "-0.19891237", "0.19891237", step=2, first=1)
    tangent = constant(ELEMENTARY, ANGLE, r"(0\.414213562373095049)")
    over1 = constant(ELEMENTARY, ANGLE, r"large \* (0\.198912367379658)")
    over3 = constant(ELEMENTARY, ANGLE, r"large \* (0\.668178637919299)")
    pi = constant(ELEMENTARY, ANGLE, PI)
    worst = Fraction(0)
    fuzz = Fraction(1, 2**52)  # a threshold is rounded once
    for t, base, low, high in ((0.0, 0.0, 0, over1), (tangent, pi / 8, over1, over3), (1.0, pi / 4, over3, 1)):
        least, most = (Fraction(low) * (1 - fuzz) - Fraction(t)) / (1 + Fraction(t) * Fraction(low)), Fraction(0)
        most = (min(Fraction(high) * (1 + fuzz), 1) - Fraction(t)) / (1 + Fraction(t) * Fraction(high))
        if not (Fraction(-19891237, 10**8) < least and most < Fraction(19891237, 10**8)):
            raise AssertionError("the thresholds leave the range that is approximated")
        total = f"{FLOAT64}({number(base)} + z * p0)" if fused else f"{FLOAT64}({number(base)} + {FLOAT64}(z * p0))"
        multiplied = "T * L" if fused else f"{FLOAT64}(T * L)", "T * S" if fused else f"{FLOAT64}(T * S)"
        definitions = f"""T = {number(t)};
L = {FLOAT64}(L_); S = {FLOAT64}(S_);
n = {FLOAT64}(S - {multiplied[0]});
d = {FLOAT64}(L + {multiplied[1]});
exact_n = S - T * L; exact_d = L + T * S;
Z = exact_n / exact_d;
q = n / d;
W = Z * Z;
w {FLOAT64}= z * z;
{horner('p', 'w', 'W', table, FLOAT64, fused)}
sum = {total};
exact_sum = {number(base)} + Z * exact_p0;
angle = {FLOAT64}(HALF_PI - sum);
exact_angle = HALF_PI - exact_sum;"""
        quotient = f"Z in [-0.19891237,0.19891237] /\\ L in [1,2] /\\ S in [0,2] /\\ S / L in [0,1]"
        of_quotient = gappa(definitions, quotient, "q - Z", hints="q - Z -> (n - exact_n) / d - Z * ((d - exact_d) / d)"
                            " { d <> 0, exact_d <> 0 };\n$ L in 4;")
        of_z = of_quotient + (division) * (Fraction(19891237, 10**8) + of_quotient)
        given = f"Z in [-0.19891237,0.19891237] /\\ {within('z - Z', of_z)} /\\ HALF_PI in [1.5707963,1.5707964]"
        plain, other = gappa(definitions, given, "sum - exact_sum", "angle - exact_angle", hints="$ Z in 8;")
        base_error = sollya(f"abs({exact(base)} - atan({exact(t)}))")
        half_pi = sollya(f"abs({exact(pi / 2)} - pi / 2)")
        approximated = approximation * sollya("atan(0.19891237)")
        worst = max(worst, plain + base_error + approximated, other + base_error + approximated + half_pi)
    return worst


def first_quadrant_angle(fused):
    expect(ELEMENTARY, ANGLE)
    return {"kQuickAngleError": quadrant(fused, "kQuick", quick_division()),
            "kExactAngleError": quadrant(fused, "kExact", U64)}


PIECES = 16


def of_series(low, high, fused, rnd, sine, cosine):
    """Of an angle t between low and high, what the sine's and the cosine's own operations lose."""
    definitions = f"""t = {rnd}(T);
W = t * t;
w = {rnd}(t * t);
{horner('s', 'w', 'W', sine, rnd, fused)}
{horner('c', 'w', 'W', cosine, rnd, fused)}
sine = {rnd}(t * s0);
exact_sine = t * exact_s0;"""
    return gappa(definitions, f"T in [{low},{high}]", "sine - exact_sine", "c0 - exact_c0", hints="$ T in 3;")


def of_angle(low, high, rnd, pi):
    """Of (x - 1/2) pi for x between low and high."""
    return gappa(f"x = {rnd}(X);\nangle = {rnd}({rnd}(x - 0.5) * {number(pi)});\nA = (x - 0.5) * PI;",
                 f"X in [{low},{high}] /\\ PI in [3.14159265358979323846,3.14159265358979323847]", "angle - A")


def of_doubling(sine, cosine, rnd):
    """What turn's own operations lose, for sines in an interval and cosines up to a number."""
    definitions = f"s = {rnd}(S);\nc = {rnd}(C);\ndouble = {rnd}(2 * {rnd}(s * s) - 1);\nproduct = {rnd}(2 * {rnd}(s * c));"
    given = f"S in [{sine[0]},{sine[1]}] /\\ {within('C', Fraction(cosine))}"
    return gappa(definitions, given, "double - (2 * (s * s) - 1)", "product - 2 * (s * c)", hints="$ S in 2;")


def turns(fused, head, rnd, rounded):
    """Worst of half_turn and of turn: the errors of sine and cosine, each with the angle's, and what they make of 2 s^2 - 1 and 2 s c."""
    sine, cosine = ([rounded(c) for c in array(WARP, head, name)] for name in ("kSine", "kCosine"))
    approximated_sine = supnorm(sine, "sin(x)", "-1.571", "1.571", "absolute", step=2, first=1)
    approximated_cosine = supnorm(cosine, "cos(x)", "-1.571", "1.571", "absolute", step=2)
    pi = rounded(constant(WARP, HALF_OF, PI))
    half = whole = Fraction(0)
    for k in range(PIECES // 2):  # by the angle's size; x is below 1/2 or above
        low, high = math.pi / PIECES * k, math.pi / PIECES * (k + 1)
        near, far = (0.5 - (k + 1) / PIECES, 0.5 - k / PIECES), (0.5 + k / PIECES, 0.5 + (k + 1) / PIECES)
        angle = max(of_angle(*near, rnd, pi), of_angle(*far, rnd, pi))
        own = of_series(max(low - 1e-6, 0), high + 1e-6, fused, rnd, sine, cosine)
        least_s, most_s, most_c = math.sin(low) - 1e-5, math.sin(high) + 1e-5, math.cos(low) + 1e-5
        doubling = of_doubling((max(least_s, 0), most_s), most_c, rnd)
        s, c = Fraction(most_s), Fraction(most_c)
        of_sine = own[0] + approximated_sine + angle * c
        of_cosine = own[1] + approximated_cosine + angle * s
        half = max(half, of_sine, of_cosine)
        whole = max(whole, doubling[0] + 2 * of_sine * (2 * s + of_sine),
                    doubling[1] + 2 * (s * of_cosine + (c + of_cosine) * of_sine))
    return half, whole


def turn(fused):
    expect(WARP, HALF_OF, HALF, HALF_FLOAT, TURN)
    half, whole = turns(fused, HALF_FLOAT, FLOAT32, float32)
    exact_half, exact_whole = turns(fused, HALF, FLOAT64, float)
    return {"kHalfTurnError": half, "kTurnError": whole, "kExactHalfTurnError": exact_half, "kExactTurnError": exact_whole}
