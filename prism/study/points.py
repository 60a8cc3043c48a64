"""The sets of parameters that are measured, for the running converter and for the model that describes it."""

from collections.abc import Mapping
from dataclasses import dataclass

from study.checking import Number
from study.phases import Phases


@dataclass(frozen=True)
class Mode:
    """How the converter's loop is run, and how much is measured; with threads it runs slower."""

    name: str
    options: tuple[str, ...]
    short_runs: int
    batch_s: int


MODES = (
    Mode("steps", (), short_runs=2500, batch_s=2400),
    Mode("threads", ("--threads",), short_runs=250, batch_s=240),
)
"""Step by step on one thread, or by a thread for each component."""

BATCHES = 100
"""The number of batches in a long run, in both modes."""


@dataclass(frozen=True)
class Point:
    """One set of parameters: for the converter, and for the model that describes it."""

    name: str
    mechanism: str
    model: str
    constants: Mapping[str, Number]
    left_out: frozenset[str] = frozenset()
    """Quantities that the model does not have, or means otherwise."""

    @property
    def disturbed(self) -> bool:
        return self.model in ("crash", "sight", "swap")

    def parameter(self, name: str, default: Number) -> Number:
        return self.constants.get(name, default)


_CRASHES = {"conversion": 0.25, "K": 4, "crash": 20.0, "recovery": 5.0}
_OUT_OF_SIGHT = {"conversion": 0.25, "K": 4, "sight": 20.0, "away": 5.0}
# As far from exponential as the benchmarks' measurement of 2026-11-22, and slow enough to matter.
_LOOP = Phases(phases=1, first=1.0, more=0.1, last=4.0).with_mean(1.0)
_BUTTON = Phases(phases=1, first=1.0, more=0.3, last=1.0).with_mean(1.0)

POINTS = (
    Point("unbuffered, 0.25 s", "unbuffered", "exact", {"conversion": 0.25}),
    Point("unbuffered, 1 s", "unbuffered", "exact", {"conversion": 1.0}),
    Point("pipelined K=1, 0.25 s", "pipelined", "fifo-pipelined", {"conversion": 0.25, "K": 1}),
    Point("pipelined K=2, 0.25 s", "pipelined", "fifo-pipelined", {"conversion": 0.25, "K": 2}),
    Point("pipelined K=4, 0.25 s", "pipelined", "fifo-pipelined", {"conversion": 0.25, "K": 4}),
    Point("pipelined K=8, 0.25 s", "pipelined", "fifo-pipelined", {"conversion": 0.25, "K": 8}),
    Point("pipelined K=4, 1 s", "pipelined", "fifo-pipelined", {"conversion": 1.0, "K": 4}),
    Point("serial K=4, 0.5 s", "serial", "fifo-serial", {"conversion": 0.5, "K": 4}),
    Point("two events, K=4, 0.25 s", "pipelined", "path", {"conversion": 0.25, "K": 4, "steps": 2, "action": 0.5}),
    Point("hold-off 1 s, K=8, 0.25 s", "holdoff", "holdoff", {"conversion": 0.25, "K": 8, "holdoff": 1.0}),
    Point("times spread as the loop's, K=4, 1 s", "pipelined", "phases", {"K": 4, **_LOOP.constants()}),
    Point("times spread as the button's, K=4, 1 s", "pipelined", "phases", {"K": 4, **_BUTTON.constants()}),
    Point("crashes, journal", "pipelined", "crash", {**_CRASHES, "journal": 1}),
    # An event lost in a crash arrived earlier, so until 100 s the model and the bench count it at different times.
    Point("crashes, no journal", "pipelined", "crash", {**_CRASHES, "journal": 0}, frozenset(("lost", "wait_s"))),
    Point("out of sight", "pipelined", "sight", {**_OUT_OF_SIGHT, "operated": 0.0}),
    # The model does not cover events that were decided before the device was operated.
    Point(
        "out of sight, operated",
        "pipelined",
        "sight",
        {**_OUT_OF_SIGHT, "operated": 0.2},
        frozenset(("lost", "handed", "completion_s", "wait_s", "lost_per_s")),
    ),
    Point("swaps", "pipelined", "swap", {"conversion": 0.5, "K": 2, "swap": 10.0, "pause": 2.0}),
)

MEASURED = tuple(
    (mode, point) for mode in MODES for point in POINTS if not (point.disturbed and mode.name == "threads")
)
"""The measured points. Disturbed ones only without threads, since threads cannot be ended in the middle of their work."""
