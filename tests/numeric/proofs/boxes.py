"""weighted_log2_1p in float64, where what rounding takes depends on where the numbers lie between powers of two.

What one rounding takes is at most u = 2^-53 of a number, and u/2 of one that is nearly twice a power of two. A dozen roundings
meet here; that each is worst at once is excluded by the numbers themselves. s and c are covered by small boxes, c between 1 and 2,
in each of which every rounding is bounded by the interval of its number. Errors are in units of u; the products of two of
them, and what the intervals' own arithmetic loses, are covered by SLACK.
"""
import math

SLACK = 1 + 1e-9


def rounding(interval):
    """The largest relative error of rounding a number of the interval, in u."""
    low, high = sorted(abs(x) for x in interval)
    if interval[0] <= 0 <= interval[1]:
        return 1.0
    power = 2.0 ** math.floor(math.log2(high))
    return 1.0 if low <= power else power / low


def times(x, y):
    ends = [a * b for a in x for b in y]
    return min(ends), max(ends)


def inverse(x):
    return 1 / x[1], 1 / x[0]


def error(k, s, c, series, fused, w=None, a=None, of_sum=None, of_difference=None, squared=None):
    """Of (w/s) (k + z P), k = 0 or 1, for s and c in intervals. `series` is (least P, largest P, its error in u for its own roundings
    and z's error, its approximation's). Where w is not given it is any number; what can be told better than from the intervals (a, the rounding of s + c and of s - c, the
    product of s and the numerator) is given."""
    power = 2.0**k
    a = a or (s[0] + c[0], s[1] + c[1])
    of_sum = rounding(a) if of_sum is None else of_sum
    denominator = a[0] + power * c[0], a[1] + power * c[1]
    numerator = s if k == 0 else (s[0] - c[1], s[1] - c[0])
    of_denominator = of_sum / (1 + power * c[0] / a[1]) + rounding(denominator)
    of_numerator = 0 if k == 0 else rounding(numerator) if of_difference is None else of_difference
    product = times(denominator, s)
    of_inverse = rounding(product) + rounding(inverse(product))
    z = times(numerator, inverse(denominator))
    z = max(z[0], -0.2001), min(z[1], 0.2001)  # nearest_power
    of_z = of_numerator + rounding(squared or times(numerator, s)) + of_inverse + of_denominator + rounding(z)
    term = times(z, series[:2])
    of_term = of_z + series[2] + series[3] + (0 if fused or k == 0 else rounding(term))
    total = k + term[0], k + term[1]
    of_total = rounding(total) + of_term * (1 if k == 0 else max(abs(x) / (1 + x) for x in term))
    quotient = None if w is None else times(w, inverse(s))
    of_quotient = of_inverse + (2 if w is None else rounding(times(w, denominator)) + rounding(quotient))
    last = 1.0 if w is None else rounding(times(quotient, total))
    return (of_total + of_quotient + last) * SLACK


def chooses(k, s, c):
    """Whether nearest_power chooses this k anywhere in the box: see logarithms.py, with i - j = 0 and 1."""
    a = s[0] + c[0], s[1] + c[1]
    if k == 0:
        return (a[0] < 2 and s[0] < 0.5 + 1e-12) or (a[1] >= 2 and a[0] < 2 * c[1] - 1 + 1e-12)
    return s[1] > 0.5 - 1e-12 and (a[0] < 2 or a[1] > 2 * c[0] - 1 - 1e-12)


def steps(low, high, count):
    ends = [low * (high / low) ** (i / count) for i in range(count + 1)]
    return [(x * (1 - 1e-14), y * (1 + 1e-14)) for x, y in zip(ends, ends[1:])]


def general(series, fused):
    """For any w, s and c, in u; smaller s than 2^-10 differ from those of the first binade here by a power of two."""
    worst = 0.0
    for c in steps(1, 2, 48):
        for s in steps(2.0**-11, 1, 11 * 24):
            if chooses(0, s, c):
                a = (c[0], c[1] + 2.0**-10) if s[1] < 2.0**-10 else None
                worst = max(worst, error(0, s, c, series, fused, a=a))
        for s in steps(0.49, 4, 100):
            if chooses(1, s, c):
                worst = max(worst, error(1, s, c, series, fused))
    return worst


def of_rest(series, fused):
    """For w = s = x, c = 1 - x, x up to 1/2. c is off by 2^-54 at most, so that s + c is as well, and rounded 1; from x = 1/4 on
    s - c is exact, a multiple of 2^-54 below 1/2, and s (c - s) = x (1 - 2x) falls from 1/8. What c's error makes of the whole is
    half of x / ((1 - x) |log(1 - x)|), which grows."""
    worst = 0.0
    for k, low, high in ((0, 2.0**-11, 0.25), (1, 0.25, 0.5)):
        for x in steps(low, high, 1000):
            c = (1 - 2.0**-10, 1.0) if x[1] < 2.0**-10 else (1 - x[1], 1 - x[0])
            squared = (x[1] * (1 - 2 * x[1]), min(x[0] * (1 - 2 * x[0]), 0.125 * (1 - 1e-12))) if k == 1 else None
            of_rest_itself = x[1] / ((1 - x[1]) * -math.log1p(-x[1])) / 2
            worst = max(worst, of_rest_itself + error(k, x, c, series, fused, w=x, a=(1.0, 1.0), of_sum=0.5, of_difference=0,
                                                      squared=squared))
    return worst
