"""Measures the running converter."""

import csv
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

from study.estimates import NEVER, Estimate, estimate
from study.paper import ARRIVALS_PER_S
from study.points import MEASURED, Mode, Point
from study.problem import Problem
from study.tables import Table

MEASUREMENTS = "experiment-measured"
"""The table that the experiment writes; reports use it until the next measurement."""

_JAR = Path(__file__).resolve().parent.parent / "experiment" / "target" / "study-experiment.jar"


class Measurements:
    """The experiment's measurements, by mode, point, quantity and time."""

    def __init__(self, rows: list[dict[str, str]]) -> None:
        self._rows = {(row["mode"], row["point"], row["quantity"], int(row["t"])): row for row in rows}

    def seed(self, mode: Mode, point: Point) -> int:
        return int(self._rows[mode.name, point.name, "events", 0]["seed"])

    def estimate(self, mode: Mode, point: Point, quantity: str, time_s: int = 0) -> Estimate:
        row = self._rows.get((mode.name, point.name, quantity, time_s))
        return NEVER if row is None else estimate(int(row["n"]), float(row["mean"]), float(row["deviation"]))

    def least_events(self, mode: Mode) -> int:
        """The smallest number of events of any point, in its short runs and its long one together."""
        return min(self._events(mode, point) for one, point in MEASURED if one == mode)

    def _events(self, mode: Mode, point: Point) -> int:
        short, long = (self._rows[mode.name, point.name, quantity, 0] for quantity in ("events", "events_long_run"))
        return round(int(short["n"]) * float(short["mean"]) + float(long["mean"]))


def measure(first_seed: int, progress: Callable[[str], None]) -> Table:
    """Runs the experiment; each point has its own seed in each mode, counted up from the first one."""
    if not _JAR.is_file():
        raise Problem(f"{_JAR} is missing; run the study as ./evoloop study --experiment, which builds it")
    java = shutil.which("java")
    if java is None:
        raise Problem("there is no java on the PATH; ./evoloop setup installs it")
    table = Table(MEASUREMENTS, ("mode", "point", "seed", "quantity", "t", "n", "mean", "deviation"))
    for seed, (mode, point) in enumerate(MEASURED, start=first_seed):
        progress(f"measuring {point.name} in {mode.name} (seed {seed})")
        length = ("--runs", str(mode.short_runs), "--batch", str(mode.batch_s))
        command = [java, "-jar", str(_JAR), *length, *mode.options]
        done = subprocess.run(command, input=_line(point, seed), capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Problem(f"the experiment failed at {point.name} in {mode.name}: {done.stderr.strip() or done.returncode}")
        for row in csv.DictReader(done.stdout.splitlines()):
            table.add(mode.name, point.name, seed, *(row[column] for column in table.header[3:]))
    return table


_COLUMNS = ("K", "steps", "conversion", "action", "holdoff")
"""Constants with their own columns."""


def _line(point: Point, seed: int) -> str:
    """A point as the experiment reads it; a name with a comma would become two cells."""
    cells = (
        "point",
        point.mechanism,
        point.parameter("K", 1),
        point.parameter("steps", 1),
        ARRIVALS_PER_S,
        point.parameter("conversion", 0),
        point.parameter("action", 1),
        point.parameter("holdoff", 0),
        seed,
        " ".join(f"{name}={value}" for name, value in point.constants.items() if name not in _COLUMNS),
    )
    return ",".join(str(cell) for cell in cells) + "\n"


def load(folder: Path) -> Measurements | None:
    """The stored measurements; None if there are none."""
    path = folder / f"{MEASUREMENTS}.csv"
    if not path.is_file():
        return None
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if {(row.get("mode"), row.get("point")) for row in rows} != {(mode.name, point.name) for mode, point in MEASURED}:
        raise Problem(f"{path} is not of this version; measure again with ./evoloop study --experiment, or remove it")
    return Measurements(rows)
