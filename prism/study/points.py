"""What is measured: sets of parameters, for the converter that runs and for the model that describes it."""

from collections.abc import Mapping
from dataclasses import dataclass

from study.checking import Number

@dataclass(frozen=True)
class Mode:
    """How the converter's loop is driven, and how much is measured: threads that wake each other take their time."""

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
"""Of a long run, in both modes."""


@dataclass(frozen=True)
class Point:
    """One set of parameters: for the converter, and for the model that describes it."""

    name: str
    mechanism: str
    model: str
    constants: Mapping[str, Number]

    def parameter(self, name: str, default: Number) -> Number:
        return self.constants.get(name, default)


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
)
