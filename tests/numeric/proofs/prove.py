#!/usr/bin/env python3
"""Proves the bounds of src/numeric/errors.h.

  prove.py [FUNCTION...]            proves those of all functions, or of these; fails unless errors.h states what is proved
  prove.py --found PROGRAM [...]    also searches for the worst errors, by build/bin/print_worst_errors, and fails if one exceeds its
                                    bound or comes to less than half of it, or if README.md says otherwise
  prove.py --table PROGRAM          prints the table of README.md
"""
import subprocess
import sys
from pathlib import Path

import angles
import exponentials
import logarithms
import products
from source import ISAS, Failure, stated

PROOFS = {
    exponentials.times_exp2_quick: ["kTimesExp2Error"],
    exponentials.times_exp2_exact: ["kExactTimesExp2Error"],
    logarithms.weighted_log2_1p: ["kQuickWeightedLog2Error", "kExactWeightedLog2Error"],
    angles.first_quadrant_angle: ["kQuickAngleError", "kExactAngleError"],
    products.exact_dot: ["kExactDotError"],
    logarithms.log2_of_rest: ["kLog2OneMinusError"],
    logarithms.exact_log2_of_rest: ["kExactLog2OneMinusError"],
    exponentials.exp2_of_floats: ["kExp2Error", "kOneMinusExp2Error"],
    exponentials.exp2_of_doubles: ["kExactExp2Error", "kExactOneMinusExp2Error"],
    angles.turn: ["kHalfTurnError", "kTurnError", "kExactHalfTurnError", "kExactTurnError"],
    products.divide: ["kQuickDivisionError"],
    products.inverse_length: ["kInverseLengthError", "kFloatInverseLengthError"],
}
README = Path(__file__).parent / "README.md"


def rounded_up(x):
    """To three digits, as errors.h states bounds."""
    exponent = 0
    while x * 10**exponent < 100:
        exponent += 1
    digits = -(-(x * 10**exponent).numerator // (x * 10**exponent).denominator)
    return float(f"{digits}e-{exponent}")


def prove(proof):
    """Bounds by name, without and with fused multiplication and addition; fails unless errors.h states the larger one."""
    plain, fused = proof(False), proof(True)
    for name in PROOFS[proof]:
        needed, said = rounded_up(max(plain[name], fused[name])), stated()[name]
        if said != needed:
            raise Failure(f"errors.h states {name} = {said:.3g}; {needed:.3g} is proved, in three digits rounded up")
    return {name: (float(plain[name]), float(fused[name])) for name in PROOFS[proof]}


def found_by(program, names):
    """Worst errors by bound and instruction set, and the names of those that only an estimate makes."""
    done = subprocess.run([program, *names], text=True, capture_output=True, timeout=600, check=True)
    worst, estimated = {}, set()
    for line in done.stdout.splitlines():
        name, isa, value, *rest = line.split()
        worst.setdefault(name, {})[isa] = float(value)
        if rest:
            estimated.add(name)
    return worst, estimated


def rows_of(proof, program):
    """Of README.md; fails if a bound is found to be exceeded, or nothing comes within half of it."""
    proved = prove(proof)
    worst, estimated = found_by(program, proved)
    for name, (plain, fused) in proved.items():
        found, most = worst[name], max(worst[name].values())
        if most > stated()[name]:
            raise Failure(f"{name}: {most:.3g} occurs, {stated()[name]:.3g} is stated")
        ratio = max(plain, fused) / most
        if ratio > 2 and (len(found) == len(ISAS) or name not in estimated):
            raise Failure(f"{name}: {max(plain, fused):.3g} is proved and {most:.3g} the worst found, less than half")
        yield [f"`{name}`", f"{stated()[name]:.3g}", f"{plain:.3g}", f"{fused:.3g}",
               *(f"{found[isa]:.3g}" if isa in found else "?" for isa in ISAS), f"{ratio:.2f}"]


def line(cells):
    return "| " + " | ".join(cells) + " |"


def check(row):
    """README.md's line for this row: what is searched for may differ by a tenth, or be of an instruction set that is not here."""
    page = README.read_text()
    kept = [cells for cells in ([cell.strip() for cell in text.strip("| ").split("|")] for text in page.splitlines())
            if cells[0] == row[0]]
    near = kept and all(found == "?" or abs(float(cell) / float(found) - 1) < 0.1 for cell, found in zip(kept[0][4:7], row[4:7]))
    if len(kept) != 1 or kept[0][:4] != row[:4] or not near:
        raise Failure(f"{README.name} should say\n{line(row)}\nprove.py --table prints its table")


def print_table(program):
    head = ["bound", "stated", "proved without FMA", "with FMA", *(f"worst found, {isa}" for isa in ISAS), "proved / found"]
    rows = {row[0].strip("`"): row for proof in PROOFS for row in rows_of(proof, program)}
    for cells in [head, ["---"] * len(head), *(rows[name] for name in stated())]:
        print(line(cells))


def main(arguments):
    if {name for names in PROOFS.values() for name in names} != set(stated()):
        raise Failure("the bounds that errors.h states and those that have a proof are not the same")
    if arguments[:1] == ["--table"] and len(arguments) == 2:
        print_table(arguments[1])
        return
    program = arguments[1] if arguments[:1] == ["--found"] and len(arguments) > 1 else None
    known = {proof.__name__: proof for proof in PROOFS}
    for name in (arguments[2:] if program else arguments) or known:
        if name not in known:
            raise Failure(f"no proof is called '{name}'; there are {', '.join(known)}, and the options --found and --table")
        if program:
            for row in rows_of(known[name], program):
                check(row)
                print(line(row))
        else:
            for bound, (plain, fused) in prove(known[name]).items():
                print(f"{bound}: {plain:.3g} without FMA, {fused:.3g} with; stated and proved", flush=True)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Failure as why:
        sys.exit(f"prove.py: {why}")
