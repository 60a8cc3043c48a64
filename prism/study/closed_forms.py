"""Values derived by hand, to verify checkers and models."""

import math
from dataclasses import dataclass

from study.checking import Checker
from study.paper import ARRIVALS_PER_S, HORIZON_S

_TOLERANCE = 1e-6
_ACTIONS_PER_S = 1.0
_ACTIONS = 19
_CONVERSION_S = 0.25
_SIGHT_S = 20.0
_AWAY_S = 5.0
_OPERATED_PER_S = 0.3


@dataclass(frozen=True)
class Check:
    """A value of the study beside the known one."""

    what: str
    value: float
    known: float

    def holds(self) -> bool:
        return abs(self.value - self.known) < _TOLERANCE

    def __str__(self) -> str:
        return f"{'ok  ' if self.holds() else 'FAIL'} {self.what}: {self.value:.6f}, known {self.known:.6f}"


def checks(checker: Checker) -> list[Check]:
    arrivals = {"event_arrive": ARRIVALS_PER_S}
    converter = {**arrivals, "conversion": _CONVERSION_S}
    at_end = {"T": HORIZON_S}
    baseline = checker.check("baseline", "longrun", arrivals)
    exact = checker.check("exact", "longrun", converter)
    single = checker.check("fifo-serial", "longrun", {**converter, "K": 1})
    pipelined = checker.check("fifo-pipelined", "paper", {**converter, **at_end, "K": 8}).value("lost")
    path = checker.check("path", "paper", {**converter, **at_end, "K": 8, "steps": 1, "action": 1}).value("lost")
    belief = checker.check("fifo-pipelined", "belief", {**converter, **at_end, "K": 8})
    phases = {"phases": 1, "first": _CONVERSION_S, "more": 0.0, "last": 1.0}
    alike = checker.check("phases", "paper", {**arrivals, **phases, **at_end, "K": 8}).value("lost")
    away = {**converter, "K": 4, "sight": _SIGHT_S, "away": _AWAY_S, "operated": _OPERATED_PER_S}
    crashing = {**converter, "K": 4, "journal": 0, "crash": _SIGHT_S, "recovery": _AWAY_S}
    return [
        Check(
            "baseline, lost until 100 s",
            checker.check("baseline", "paper", {**arrivals, **at_end}).value("lost"),
            baseline_lost(HORIZON_S),
        ),
        Check("baseline, mean completion in s", baseline.value("completion"), _ACTIONS * (2 + 1)),
        Check("baseline, lost per s", baseline.value("lost_rate"), 1 / 6),
        Check("exact at 0.25 s, lost per s", exact.value("lost_rate"), unbuffered_lost_per_s(_CONVERSION_S)),
        Check("fifo-serial with K=1 at 0.25 s, mean completion in s", single.value("completion"), 49.75),
        Check("path of one event against fifo-pipelined, lost until 100 s", path, pipelined),
        Check("fifo-pipelined with K=8, probability that belief and device differ", belief.value("differed"), 0.0),
        Check("phases of one phase against fifo-pipelined, lost until 100 s", alike, pipelined),
        Check("sight, share of time that differs", checker.check("sight", "differs", away).value("differs"), operated_share()),
        Check(
            "crash without a journal, share of time that differs",
            checker.check("crash", "differs", crashing).value("differs"),
            2 / 3 * _SIGHT_S / (_SIGHT_S + _AWAY_S),
        ),
    ]


def operated_share() -> float:
    """The share of time in which a device is not where it was last seen: on a ring of three, each operation moves it by one."""
    moved = _OPERATED_PER_S / (_OPERATED_PER_S + 1 / _AWAY_S)
    unmoved = (1 - moved) / (1 - moved**3)
    return (1 - unmoved) * _AWAY_S / (_SIGHT_S + _AWAY_S)


def baseline_lost(time_s: float) -> float:
    """Arrivals during actions: the device acts with probability a(1-exp(-(a+s)t))/(a+s), and then loses a per second."""
    total = ARRIVALS_PER_S + _ACTIONS_PER_S
    busy_s = ARRIVALS_PER_S / total * (time_s - (1 - math.exp(-total * time_s)) / total)
    return ARRIVALS_PER_S * busy_s


def unbuffered_lost_per_s(conversion_s: float, arrivals_per_s: float = ARRIVALS_PER_S) -> float:
    """
    The long-run losses of the paper's mechanism: arrivals minus actions done.

    With arrivals a, conversions c and actions s a second, it does c(c+a+s)/((c+a)(c+s)) times the actions of the device
    alone, which does as/(a+s).
    """
    converted = 1 / conversion_s
    alone = arrivals_per_s * _ACTIONS_PER_S / (arrivals_per_s + _ACTIONS_PER_S)
    share = converted * (converted + arrivals_per_s + _ACTIONS_PER_S)
    share /= (converted + arrivals_per_s) * (converted + _ACTIONS_PER_S)
    return arrivals_per_s - share * alone
