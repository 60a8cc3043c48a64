"""Disturbances of a converter: its process crashes, the device is unreachable, its models are replaced."""

from collections.abc import Mapping

from study.checking import Checker, Number
from study.paper import ARRIVALS_PER_S, HORIZON_S
from study.tables import Table
from study.waiting import mean_wait_s

CONVERSION_S = 0.25
CAPACITY = 8
EVERY_S = (20.0, 60.0, 300.0)
DOWN_S = (1.0, 5.0)
AWAY_S = (1.0, 5.0, 20.0)
OPERATED_PER_S = 0.1
PAUSES_S = (0.001, 0.1, 1.0)
RESTART_S = 1.0

DIFFERING = ("crash", "sight")
"""Models in which the recorded and the true state can differ."""

_SHARED = {"event_arrive": ARRIVALS_PER_S, "conversion": CONVERSION_S, "K": CAPACITY}
_FOUND = ("lost", "handed", "completion_s", "lost_per_s", "mean_wait_s", "divergence_s", "differs")


def crash_table(checker: Checker) -> Table:
    table = Table("crash", ("journal", "crash", "recovery", *_FOUND))
    for every in EVERY_S:
        for down in DOWN_S:
            for journal in (1, 0):
                given = {"journal": journal, "crash": every, "recovery": down}
                table.add(journal, every, down, *_found(checker, "crash", given))
    return table


def sight_table(checker: Checker) -> Table:
    table = Table("sight", ("sight", "away", "operated", *_FOUND))
    for away in AWAY_S:
        given = {"sight": EVERY_S[1], "away": away, "operated": OPERATED_PER_S}
        table.add(*given.values(), *_found(checker, "sight", given))
    return table


def swap_table(checker: Checker) -> Table:
    """The models are replaced in the running process, or by a restart, which takes longer."""
    table = Table("swap", ("way", "every", "pause", *_FOUND))
    every = EVERY_S[0]
    for pause in PAUSES_S:
        table.add("swap", every, pause, *_found(checker, "swap", {"swap": every, "pause": pause}))
    for journal, way in ((1, "restart with a journal"), (0, "restart without one")):
        given = {"journal": journal, "crash": every, "recovery": RESTART_S}
        table.add(way, every, RESTART_S, *_found(checker, "crash", given))
    return table


def _found(checker: Checker, model: str, given: Mapping[str, Number]) -> tuple[float, ...]:
    constants = {**_SHARED, **given}
    at_end = {**constants, "T": HORIZON_S}
    long_run = checker.check(model, "longrun", constants)
    return (
        checker.check(model, "paper", at_end).value("lost"),
        checker.check(model, "handed", at_end).value("handed"),
        long_run.value("completion"),
        long_run.value("lost_rate"),
        mean_wait_s(checker.check(model, "waiting", constants)),
        checker.check(model, "belief", at_end).value("divergence"),
        checker.check(model, "differs", constants).value("differs") if model in DIFFERING else 0.0,
    )
