"""Quick division, lengths' inverses and products of vectors."""
from fractions import Fraction

from source import ISAS, array, constant, exact, expect, float32, stated
from tools import FLOAT32, FLOAT64, U32, U64, gappa, horner, sollya, supnorm, together


def quick_division():
    """AVX-512's divide_fast: r = (1 - e) / b with |e| <= 2^-14, as the processors' manuals promise of rcp14. Then
    r (1 + e + e^2) = (1 - e^3) / b; e, e^2 + e, r and the product with a are rounded once each."""
    expect("isa_avx512.h", "GONIO_INLINE D divide_fast")
    e = Fraction(1, 2**14)
    inner = (e + e * e) * (together(U64, U64) + U64 * 2)
    return together(e**3, inner, U64, U64)


def divide(_):
    return {"kQuickDivisionError": quick_division()}


LENGTHS = 2.1e-3  # |k|^2 - 1 of a length within 1e-3 of 1


def inverse_length(fused):
    found = {}
    for name, rnd, rounded, head in (
            ("kInverseLengthError", FLOAT64, float, "static GONIO_INLINE Wide inverse_length(Wide e) {\n    static"),
            ("kFloatInverseLengthError", FLOAT32, float32, "static GONIO_INLINE Real inverse_length(Real e)")):
        expect("number.h", head)
        table = [rounded(c) for c in array("number.h", head, "kSeries")]
        approximation = supnorm(table, "1/sqrt(1 + x)", f"-{LENGTHS}", LENGTHS)
        definitions = f"e = {rnd}(E);\n{horner('p', 'e', 'e', table, rnd, fused)}"
        rounding = gappa(definitions, f"E in [-{LENGTHS},{LENGTHS}]", "p0 -/ exact_p0", hints="$ E in 16;")
        found[name] = together(approximation, rounding)
    return found


def exact_dot(_):
    """Products and sums with what rounding took from them are theorems (Dekker 1971; Knuth), as long as nothing falls out of
    range. The result is fl(three + fl(fl(fl(fl(l_x + l_y) + l_z) + l_two) + l_three)), where the six terms are the product
    exactly, the l of products are at most u of them each, and l_two and l_three u of sums of them. P being the sizes of the
    products together, at most 10^15 of their sum, the errors of the four inner additions count by P, that of the last by the sum.
    (For float32 numbers the l of the products are 0.)"""
    expect("elementary.h", "GONIO_INLINE void exact_sum", "GONIO_INLINE Double<E> exact_dot")
    for isa in ISAS:
        expect(f"isa_{isa}.h", "GONIO_INLINE void exact_product")
    expect("isa_baseline.h", "GONIO_INLINE void halve_bits")
    of_products = U64 * (1 + U64)  # l_x + l_y + l_z, in parts of P
    of_sum = U64 * (1 + U64) ** 2  # l_two or l_three: of fl(x + y), of fl(two + z)
    first = together(U64, U64) * of_products
    second = U64 * (of_products + first + of_sum)
    third = U64 * (of_products + first + second + 2 * of_sum)
    return {"kExactDotError": U64 + (1 + U64) * (first + second + third) * 10**15}
