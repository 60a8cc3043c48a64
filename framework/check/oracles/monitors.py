"""Checks traces with reelay and RTAMT: prints a line "FIRST FIRST" for each, the moments of the first violations, or -1.

A line of the input is a form, its duration and the moments, one digit per tick: bit 0 is the subject and bit 1 the other.
In the formulas, f and g are these two; b is true where the subject begins and e where it ends.
"""

import itertools
import sys
from collections.abc import Callable

import reelay
import rtamt

# A violation in terms of its past: reelay supports no other direction.
_PAST = {
    "response": "(once[{d}:{d}] {{b}}) and not (once[0:{d}] {{g}})",
    "longest": "(once[{d}:{d}] {{b}}) and (historically[0:{d}] {{f}})",
    "shortest": "{{e}} and (once[1:{less}] {{b}})",
    "before": "{{b}} and not ((once[{d}:{d}] {{g}}) and (historically[1:{d}] {{g}}))",
    "count": "{{b}} and (once[1:{d}] {{b}})",
}

# What must hold at each moment, for RTAMT. Its own translation of future into past operators detects violations too late.
_KEPT = {
    "response": "(once[{d}:{d}] (b>=0.5)) implies (once[0:{d}] (g>=0.5))",
    "longest": "(once[{d}:{d}] (b>=0.5)) implies (once[0:{d}] (f<0.5))",
    "shortest": "(e>=0.5) implies (historically[1:{less}] (b<0.5))",
    "before": "(b>=0.5) implies ((once[{d}:{d}] (g>=0.5)) and (historically[1:{d}] (g>=0.5)))",
    "count": "(b>=0.5) implies (historically[1:{d}] (b<0.5))",
}

_NOTHING = {"f": False, "g": False, "b": False, "e": False}


def signals(codes: str) -> list[dict[str, bool]]:
    told, before = [], False
    for code in codes:
        f, g = int(code) & 1 != 0, int(code) & 2 != 0
        told.append({"f": f, "g": g, "b": f and not before, "e": before and not f})
        before = f
    return told


def reelay_monitor(form: str, length: int) -> Callable[[dict[str, bool]], bool]:
    monitor = reelay.discrete_timed_monitor(pattern=_PAST[form].format(d=length, less=length - 1), condense=False)
    return lambda moment: bool(monitor.update(moment)["value"])


def rtamt_monitor(form: str, length: int) -> Callable[[dict[str, bool]], bool]:
    spec = rtamt.StlDiscreteTimeSpecification()
    for name in ("f", "g", "b", "e", "out"):
        spec.declare_var(name, "float")
    spec.spec = "out = " + _KEPT[form].format(d=length, less=length - 1)
    spec.parse()
    ticks = itertools.count()
    return lambda moment: spec.update(next(ticks), [(name, float(value)) for name, value in moment.items()]) < 0


def first(violated: Callable[[dict[str, bool]], bool], trace: list[dict[str, bool]], length: int) -> int:
    """The moment of the first violation; afterwards feeds empty moments until nothing of the trace is remembered."""
    seen = [violated(moment) for moment in trace]
    for _ in range(length + 2):
        violated(_NOTHING)
    return seen.index(True) if True in seen else -1


def main() -> None:
    known: dict[tuple[str, int], list[Callable[[dict[str, bool]], bool]]] = {}
    for line in sys.stdin:
        form, length, codes = line.split()
        key = form, int(length)
        if key not in known:
            known[key] = [reelay_monitor(*key), rtamt_monitor(*key)]
        trace = signals(codes)
        print(*(first(violated, trace, key[1]) for violated in known[key]))


if __name__ == "__main__":
    main()
