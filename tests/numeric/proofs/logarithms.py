"""Logarithms: of a quotient (weighted_log2_1p), and of 1 - x (log2_of_rest)."""
from fractions import Fraction

import boxes
from products import quick_division
from source import ISAS, array, expect, float32
from tools import FLOAT32, FLOAT64, U64, gappa, horner, sollya, supnorm, together, within

ELEMENTARY, WARP = "elementary.h", "warp.h"
WEIGHTED = "GONIO_INLINE Double<E> weighted_log2_1p"
REST = "GONIO_INLINE Float log2_of_rest"
REST_EXACT = "GONIO_INLINE Double<Exactness::exact> log2_of_rest"
ONE_MINUS = "GONIO_INLINE T log2_one_minus"

# Bits of a positive float64 as a number are a piecewise linear logarithm. With a = 2^i p, c = 2^j q, p and q in [1, 2),
# nearest_power chooses k so that i - j - k + p - q is in [-1/2, 1/2); i - j - k is then -1, 0 or 1, and a / (c 2^k), which is
# (p/q) 2^(i-j-k), in [2/3, 3/2]: |z| <= 1/5. Also k = 0 for a/c < 4/3. The rounding of a moves both by less than 1e-15.
Z = "2001/10000"


class Weighted:
    """(w/s) (k + z P(z^2)), z = (s - c (2^k - 1)) / (a + c 2^k), for a = s + c to a relative error of `of_sum`.

    Relative errors: `inverse` those of 1 / (denominator s), without the denominator's own (whose addend is at most 1e-50 of it);
    the denominator's error cancels in the quotient. Each product by a power of two is exact."""

    def __init__(self, fused, table_name, division, of_sum):
        self.fused, self.table = fused, array(ELEMENTARY, WEIGHTED, table_name)
        self.approximation = supnorm(self.table, "log((1 + x) / (1 - x)) / log(2)", f"-{Z}", Z, step=2, first=1)
        self.denominator = together(of_sum, U64)
        self.inverse = together(U64, division, Fraction(1, 10**50))
        # The numerator, its product with s, their product with the inverse.
        self.of_z = together(U64, U64, self.inverse, U64, self.denominator)
        self.last = together(U64, self.inverse, U64, U64)  # w denominator inverse, and the product with the sum

    def sum(self, k, of_z, given, hints):
        """Of k + z P(z^2), z being off as `of_z` says."""
        total = f"{k} + z * p0" if k else "z * p0"
        definitions = (f"{self.series()}exact_sum = {k or '0'} + Z * exact_p0;\n" +
                       (f"sum = {FLOAT64}({total});" if self.fused else f"sum {FLOAT64}= {total};"))
        return gappa(definitions, f"{given} /\\ {of_z}", f"sum -/ {'exact_sum' if k else 'Z * exact_p0'}", hints=hints)

    def series(self):
        return f"W = Z * Z;\nw {FLOAT64}= z * z;\n{horner('p', 'w', 'W', self.table, FLOAT64, self.fused)}\n"

    def zero(self):
        """k = 0: the numerator is s."""
        return self.sum("", within("z -/ Z", self.of_z), "Z in [1b-330,0.2001]", hints="$ Z in (1b-4, 1b-3);")

    def one(self):
        """k = 1: c (2^k - 1) is c."""
        return self.sum("1", within("z -/ Z", self.of_z), "Z in [-0.2001,0.2001]", hints="$ Z in 64;")

    def many(self):
        """k >= 2: 2^k - 1 and its product with c are rounded (or only the first), each to U64 of c 2^k, which is at most 0.61 of
        the denominator."""
        absolute = self.of_z * Fraction(2002, 10000) + Fraction(123, 100) * U64
        return self.sum("K", within("z - Z", absolute), "Z in [-0.2001,0.2001] /\\ K in [2,2100]", hints="$ Z in 8, K in (2.5, 4);")

    def worst(self, *sums):
        """The approximation's error is relative to the series, which is at most 1.42 times the sum (1 - .585 for k = 1)."""
        return together(max(sums), self.approximation * Fraction(142, 100), self.last)

    def for_boxes(self):
        """The series' least and largest value, and its error, as boxes.py takes them."""
        roundings = gappa(self.series(), f"Z in [1b-330,0.2001] /\\ {within('z -/ Z', self.of_z)}", "p0 -/ exact_p0",
                          hints="$ Z in (1b-4, 1b-3);")
        largest = sum(c * 0.2001**(2 * i) for i, c in enumerate(self.table))
        return self.table[0], largest, float(roundings / U64), float(self.approximation / U64)


def weighted_log2_1p(fused):
    """Quick: a is given, to 8 roundings (the squared length of a half-vector). Exact: it is formed here."""
    expect(ELEMENTARY, WEIGHTED)
    for isa in ISAS:
        expect(f"isa_{isa}.h", "GONIO_INLINE void nearest_power")
    quick = Weighted(fused, "kQuick", quick_division(), 8 * U64)
    exactly = Weighted(fused, "kExact", U64, U64)
    small = Fraction(boxes.general(exactly.for_boxes(), fused)) * U64
    return {"kQuickWeightedLog2Error": quick.worst(quick.zero(), quick.one(), quick.many()),
            "kExactWeightedLog2Error": max(small, exactly.worst(exactly.many()))}


def exact_log2_of_rest(fused):
    """That of the quotient 1 / (1 - x); beyond x = 1/2, 1 - x is exact."""
    expect(WARP, REST_EXACT, ONE_MINUS)
    exactly = Weighted(fused, "kExact", U64, U64)
    small = Fraction(boxes.of_rest(exactly.for_boxes(), fused)) * U64
    return {"kExactLog2OneMinusError": max(small, exactly.worst(exactly.many()))}


def log2_of_rest(fused):
    """Float: 2^k (1 + f) = 1 - x. k = 0 where the rest is 3/4 or more, by a product that is rounded; then f is -x itself."""
    expect(WARP, REST, ONE_MINUS)
    table = [float32(c) for c in array(WARP, REST, "kLog2")]
    low, high = "-0.2500001", "0.5000001"
    approximation = supnorm(table, "log2(1 + x)", low, high, first=1)

    def total(k):
        terms = f"{k} + f * p0" if k else "f * p0"
        return f"sum = {FLOAT32}({terms});" if fused else f"sum {FLOAT32}= {terms};"

    polynomial = horner("p", "f", "f", table, FLOAT32, fused)
    near = f"f = {FLOAT32}(F);\n{polynomial}\n{total('')}"
    zero = together(approximation, gappa(near, "F in [-0.2500001,-1b-120]", "sum -/ (f * exact_p0)", hints="$ F in (-0.2,-0.15,-0.1,-1b-4);"))
    # Below: scaling and the difference with 1 are exact. What rounding 1 - x takes is at most 2^-25, for x in [1/4, 1/2]: k = -1.
    # Beyond x = 1/2 the difference is exact. The sum is at least .4149 in size: log2(3/4).
    far = f"f = {FLOAT32}(F);\n{polynomial}\n"
    within_one = gappa(f"{far}{total('(-1)')}\nexact_sum = (-1) + f * exact_p0;", f"F in [{low},{high}]", "sum -/ exact_sum", hints="$ F in 64;")
    beyond = gappa(f"{far}{total('K')}\nexact_sum = K + f * exact_p0;",
                   f"F in [{low},{high}] /\\ K in [-125,-2]", "sum -/ exact_sum", hints="$ F in 16, K in (-3.5);")
    series = sollya("0.58497 / 0.41503")   # at most so much of the sum is approximated
    rest = sollya("2^-25 / 0.7499 / log(2) / 0.4149")
    one = together(within_one, approximation * series, rest)
    other = together(beyond, approximation * series)
    return {"kLog2OneMinusError": max(zero, one, other)}
