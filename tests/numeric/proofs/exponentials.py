"""2^x: of float32 results (quick), of float64 ones (exact), and with 1 - 2^x beside it (exp2_of)."""
from fractions import Fraction

from source import ISAS, array, constant, exact, expect, float32
from tools import FLOAT32, FLOAT64, U32, U64, gappa, horner, number, sollya, supnorm, together

ELEMENTARY, WARP = "elementary.h", "warp.h"
POLYNOMIAL = "GONIO_INLINE T polynomial"
QUICK = "GONIO_INLINE QuickPower quick_exp2"
TIMES_QUICK = "GONIO_INLINE Float times_exp2"
TIMES_EXACT = "GONIO_INLINE Double<Exactness::exact> times_exp2"
FLOATS = "GONIO_INLINE Exp2<Float> exp2_of"
DOUBLES = "GONIO_INLINE Exp2<Double<Exactness::exact>> exp2_of"
LOG2 = r"(0\.693147180559945309)"


def times_exp2_quick(fused):
    """split_exponent leaves x = k + (m - 1) to 2^-24, m in [1, 2] a multiple of 2^-23; scaling is exact where the result is normal."""
    expect(ELEMENTARY, POLYNOMIAL, QUICK, TIMES_QUICK)
    for isa in ISAS:
        expect(f"isa_{isa}.h", "GONIO_INLINE void split_exponent", "GONIO_INLINE F scale(F x, F k)")
    table = [float32(c) for c in array(ELEMENTARY, QUICK, "kExp2")]
    approximation = supnorm(table, "2^(x - 1)", 1, 2)
    reduction = sollya("2^(2^-24) - 1")
    definitions = f"m = fixed<-23,ne>(M);\n{horner('p', 'm', 'm', table, FLOAT32, fused)}"
    rounding = gappa(definitions, "M in [1,2]", "p0 -/ exact_p0", hints="$ M in 64;")
    return {"kTimesExp2Error": together(approximation, reduction, rounding, U32)}


def of_halves(fused, head, table, first):
    """The polynomial in r = (x - k) log 2, |x - k| <= 1/2, as Gappa reads it; x - k is exact."""
    log2 = constant(ELEMENTARY if head == TIMES_EXACT else WARP, head, LOG2)
    definitions = (f"d = {FLOAT64}(D);\nr {FLOAT64}= d * {number(log2)};\n"
                   f"{horner('p', 'r', 'r', table, FLOAT64, fused)}")
    # r itself: as rounded, and for log 2 itself. Also the approximation, relative to e^r or e^r - 1.
    absolute = gappa(definitions, "D in [-0.5,0.5]", f"r - d * {number(log2)}") + sollya(f"abs({exact(log2)} - log(2)) / 2")
    function = "expm1(x)" if first else "exp(x)"
    return definitions, absolute, supnorm(table, function, "-0.3466", "0.3466", first=first)


def times_exp2_exact(fused):
    """k = round(x) and x - k are exact; x below -1000 counts as 0."""
    expect(ELEMENTARY, TIMES_EXACT)
    table = array(ELEMENTARY, TIMES_EXACT, "kExp")
    definitions, absolute, approximation = of_halves(fused, TIMES_EXACT, table, 0)
    rounding = gappa(definitions, "D in [-0.5,0.5]", "p0 -/ exact_p0", hints="$ D in 64;")
    reduction = sollya(f"expm1({exact(absolute)})")
    return {"kExactTimesExp2Error": together(approximation, reduction, rounding, U64)}


def rest_of_one(rnd, fused, change, hypotheses, hints):
    """Relative errors of power + power change and (1 - power) - power change, given the definitions of `change` and of
    exact_change as Gappa reads them, where power = 2^k: k = 0, k = -1, and k below, where power is just some number.
    Scaling by 2^k is exact, so that the first is 1 + change."""
    one, half = gappa(f"{change}\npower = {rnd}(1 + change);\nrest = {rnd}(0.5 - 0.5 * change);", hypotheses,
                      "power -/ (1 + exact_change)", "rest -/ (0.5 - 0.5 * exact_change)", hints=hints)
    whole = gappa(change, hypotheses.replace("0.5]", "-1b-120]"), "change -/ exact_change", hints=hints)
    product = "power * change" if fused else f"{rnd}(power * change)"
    below = gappa(f"{change}\npower = {rnd}(POWER);\nrest = {rnd}({rnd}(1 - power) - {product});",
                  f"{hypotheses} /\\ POWER in [0,0.25]", "rest -/ ((1 - power) - power * exact_change)")
    return one, max(whole, half, below)


def exp2_of_floats(fused):
    """x - k is exact. Below x = -100 a product may fall below float32's normal range, and with it the digits of 2^x."""
    expect(WARP, FLOATS)
    table = [float32(c) for c in array(WARP, FLOATS, "kExp2")]
    approximation = supnorm(table, "2^x - 1", "-1/2", "1/2", first=1)
    change = (f"r = {FLOAT32}(R);\n{horner('p', 'r', 'r', table, FLOAT32, fused)}\n"
              f"change {FLOAT32}= r * p0;\nexact_change = r * exact_p0;")
    power, rest = rest_of_one(FLOAT32, fused, change, "R in [-0.5,0.5]", hints="$ R in 64;")
    # Of 2^r, 2^r - 1 is at most sqrt(2) - 1; of 1 - 2^x, the part of it that 2^x holds is at most all.
    part = sollya("sqrt(2) - 1")
    return {"kExp2Error": together(approximation * part, power), "kOneMinusExp2Error": together(approximation, rest)}


def exp2_of_doubles(fused):
    expect(WARP, DOUBLES)
    table = array(WARP, DOUBLES, "kExp")
    definitions, absolute, approximation = of_halves(fused, DOUBLES, table, 1)
    change = f"{definitions}\nchange {FLOAT64}= r * p0;\nexact_change = r * exact_p0;"
    power, rest = rest_of_one(FLOAT64, fused, change, "D in [-0.5,0.5]", hints="$ D in 32;")
    # r is off by a relative U64 and by what log 2 was rounded by; e^r - 1 by 1.2 times that, r / (1 - e^-r) being below 1.2
    # for |r| <= .35, and 1 - 2^k e^r by less.
    log2 = constant(WARP, DOUBLES, LOG2)
    relative = together(U64, sollya(f"abs({exact(log2)} / log(2) - 1)")) * Fraction(6, 5)
    return {"kExactExp2Error": together(approximation * sollya("sqrt(2) - 1"), power, sollya(f"expm1({exact(absolute)})")),
            "kExactOneMinusExp2Error": together(approximation, rest, relative)}
