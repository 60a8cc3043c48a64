"""The models' predictions for what is measured."""

import math
from collections.abc import Iterator

from study.checking import Answers, Checker, Number
from study.disturbances import DIFFERING
from study.paper import ARRIVALS_PER_S, HORIZON_S, TIMES_S
from study.points import BATCHES, POINTS, Mode, Point
from study.tables import Table
from study.waiting import LONGEST_S, mean_wait_s

QUANTITIES = {
    "lost": "events lost until 100 s",
    "completion_s": "completion time in s",
    "wait_s": "waiting time in s",
    "lost_per_s": "events lost per s, in the long run",
    "divergence_s": "time until belief and device differ in s",
    "handed": "events handed over by 100 s",
    "differs": "share of time in which they differ",
}
TAIL = "longer"
"""The share of events that wait longer than a time."""

_NEARLY_NEVER = 1e-9
_LOSSES = 100
_LONG_WAITS = 1000
"""The least expected number for a meaningful interval; it is high since long waits come in bursts."""


class Predictions:
    """The models' predictions for the points."""

    def __init__(self, checker: Checker, longer: Table) -> None:
        self._checker = checker
        self._longer = {(*row[:3], row[3]): row[4] for row in longer.rows}
        self._by_time = {point.name: self._ask(point, "paper", T=TIMES_S) for point in POINTS}
        self._long_run = {point.name: self._ask(point, "longrun") for point in POINTS}
        self._waiting = {point.name: self._ask(point, "waiting") for point in POINTS}
        self._handed = {one.name: self._ask(one, "handed", T=HORIZON_S) for one in POINTS if one.disturbed}
        self._differs = {one.name: self._ask(one, "differs") for one in POINTS if one.model in DIFFERING}
        self._belief = {point.name: self._ask(point, "belief", T=HORIZON_S) for point in POINTS}

    def _ask(self, point: Point, properties: str, **more: Number | tuple[int, ...]) -> Answers:
        return self._checker.check(
            point.model, properties, {"event_arrive": ARRIVALS_PER_S, **point.constants, **more}
        )

    def lost(self, point: Point, time_s: int) -> float:
        return self._by_time[point.name].value("lost", T=time_s)

    def done(self, point: Point, time_s: int) -> float:
        return self._by_time[point.name].value("probability", T=time_s)

    def quantities(self, mode: Mode, point: Point) -> Iterator[tuple[str, int, float]]:
        """Name, time in the measurements, and value of each quantity that is frequent enough to be compared."""
        return (one for one in self._quantities(mode, point) if one[0] not in point.left_out)

    def _quantities(self, mode: Mode, point: Point) -> Iterator[tuple[str, int, float]]:
        long_run = self._long_run[point.name]
        lost, lost_per_s = self.lost(point, HORIZON_S), long_run.value("lost_rate")
        waiting = self._waiting[point.name]
        events = waiting.value("taken_rate") * BATCHES * mode.batch_s
        if lost * mode.short_runs >= _LOSSES:
            yield "lost", HORIZON_S, lost
        yield "completion_s", 0, long_run.value("completion")
        yield "wait_s", 0, mean_wait_s(waiting)
        if lost_per_s * BATCHES * mode.batch_s >= _LOSSES:
            yield "lost_per_s", 0, lost_per_s
        yield "divergence_s", 0, self._belief[point.name].value("divergence")
        if point.disturbed:
            yield "handed", HORIZON_S, self._handed[point.name].value("handed")
        if point.name in self._differs:
            differs = self._differs[point.name].value("differs")
            # If they never do, the time until they do shows that.
            if differs > _NEARLY_NEVER:
                yield "differs", 0, differs
        for time_s in range(1, LONGEST_S + 1):
            share = self.longer(point, time_s)
            if share is not None and share * events >= _LONG_WAITS:
                yield TAIL, time_s, share

    def longer(self, point: Point, time_s: int) -> float | None:
        """The probability of waiting longer, for points whose model follows a single event; None for others."""
        conversion = point.parameter("conversion", 0)
        if point.mechanism == "unbuffered":  # an event waits for its own conversion alone
            return math.exp(-time_s / conversion)
        return self._longer.get((point.model, conversion, point.constants.get("K"), time_s))
