"""The converter that runs, measured, beside the models that describe it."""

import csv
import shutil
import subprocess
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from study.checking import Answers, Checker, Number
from study.estimates import Estimate, estimate
from study.paper import ARRIVALS_PER_S, HORIZON_S, TIMES_S
from study.problem import Problem
from study.tables import Table
from study.waiting import mean_wait_s

MEASUREMENTS = "experiment-measured"
"""The table that the experiment leaves behind; reports take it up until it is measured anew."""

_JAR = Path(__file__).resolve().parent.parent / "experiment" / "target" / "study-experiment.jar"
FIRST_SEED = 1


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


@dataclass(frozen=True)
class Comparison:
    """One measured quantity beside the model's value."""

    point: Point
    seed: int
    quantity: str
    number: int
    measured: Estimate
    model: float

    def holds(self) -> bool:
        return self.measured.holds(self.model)


QUANTITIES = {
    "lost": "events lost until 100 s",
    "completion_s": "completion time in s",
    "wait_s": "waiting time in s",
    "lost_per_s": "events lost per s, in the long run",
    "divergence_s": "time until belief and device differ in s",
}


class Measurements:
    """What the experiment measured, by point, quantity and time."""

    def __init__(self, rows: list[dict[str, str]]) -> None:
        self._rows = {(row["point"], row["quantity"], int(row["t"])): row for row in rows}

    def seed(self, point: Point) -> int:
        return int(self._rows[point.name, "events", 0]["seed"])

    def number(self, point: Point, quantity: str, time_s: int = 0) -> int:
        row = self._rows.get((point.name, quantity, time_s))
        return int(row["n"]) if row else 0

    def estimate(self, point: Point, quantity: str, time_s: int = 0) -> Estimate:
        row = self._rows.get((point.name, quantity, time_s))
        if row is None:  # it never came about
            return Estimate(float("inf"), 0.0)
        return estimate(int(row["n"]), float(row["mean"]), float(row["deviation"]))

    def events(self, point: Point) -> int:
        """All events of a point, of the short runs and of the long one."""
        short, long = (self._rows[point.name, quantity, 0] for quantity in ("events", "events_long_run"))
        return round(int(short["n"]) * float(short["mean"]) + float(long["mean"]))


def measure(first_seed: int, tell: Callable[[str], None]) -> Table:
    """Runs the experiment; each point has a seed of its own, counted from the first one."""
    if not _JAR.is_file():
        raise Problem(f"{_JAR} is missing; run the study as ./evoloop study --experiment, which builds it")
    java = shutil.which("java")
    if java is None:
        raise Problem("there is no java on the PATH; ./evoloop setup installs it")
    table = Table(MEASUREMENTS, ("point", "seed", "quantity", "t", "n", "mean", "deviation"))
    for seed, point in enumerate(POINTS, start=first_seed):
        tell(f"measuring {point.name} (seed {seed})")
        done = subprocess.run(
            [java, "-jar", str(_JAR)], input=_line(point, seed), capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise Problem(f"the experiment failed at {point.name}: {done.stderr.strip() or done.returncode}")
        for row in csv.DictReader(done.stdout.splitlines()):
            table.add(point.name, seed, *(row[column] for column in table.header[2:]))
    return table


def _line(point: Point, seed: int) -> str:
    """A point as the experiment reads it; names with commas would be two cells."""
    cells = (
        "point",
        point.mechanism,
        point.parameter("K", 1),
        point.parameter("steps", 1),
        ARRIVALS_PER_S,
        point.constants["conversion"],
        point.parameter("action", 1),
        point.parameter("holdoff", 0),
        seed,
    )
    return ",".join(str(cell) for cell in cells) + "\n"


def load(folder: Path) -> Measurements | None:
    """The measurements that were made before; None if there are none."""
    path = folder / f"{MEASUREMENTS}.csv"
    if not path.is_file():
        return None
    with path.open(encoding="utf-8", newline="") as file:
        return Measurements(list(csv.DictReader(file)))


class Predictions:
    """What the models say for the points."""

    def __init__(self, checker: Checker) -> None:
        self._checker = checker
        self._by_time = {point.name: self._ask(point, "paper", T=TIMES_S) for point in POINTS}

    def _ask(self, point: Point, properties: str, **more: Number | tuple[int, ...]) -> Answers:
        return self._checker.check(
            point.model, properties, {"event_arrive": ARRIVALS_PER_S, **point.constants, **more}
        )

    def lost(self, point: Point, time_s: int) -> float:
        return self._by_time[point.name].value("lost", T=time_s)

    def done(self, point: Point, time_s: int) -> float:
        return self._by_time[point.name].value("probability", T=time_s)

    def quantities(self, point: Point) -> Iterator[tuple[str, int, float]]:
        """Name, time in the measurements, and value of each quantity."""
        long_run = self._ask(point, "longrun")
        yield "lost", HORIZON_S, self.lost(point, HORIZON_S)
        yield "completion_s", 0, long_run.value("completion")
        yield "wait_s", 0, mean_wait_s(self._ask(point, "waiting"))
        yield "lost_per_s", 0, long_run.value("lost_rate")
        yield "divergence_s", 0, self._ask(point, "belief", T=HORIZON_S).value("divergence")


def compare(measurements: Measurements, predictions: Predictions) -> list[Comparison]:
    return [
        Comparison(
            point,
            measurements.seed(point),
            quantity,
            measurements.number(point, quantity, time_s),
            measurements.estimate(point, quantity, time_s),
            model,
        )
        for point in POINTS
        for quantity, time_s, model in predictions.quantities(point)
    ]


def comparison_table(comparisons: list[Comparison]) -> Table:
    table = Table("experiment", ("point", "seed", "quantity", "n", "measured", "half_width_99", "model", "holds"))
    for one in comparisons:
        table.add(
            one.point.name,
            one.seed,
            one.quantity,
            one.number,
            one.measured.mean,
            one.measured.half_width,
            one.model,
            "yes" if one.holds() else "no",
        )
    return table
