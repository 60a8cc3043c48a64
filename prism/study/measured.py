"""The conversion time of today's converter, from the benchmarks, and what follows from it."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from study.checking import Checker
from study.paper import ARRIVALS_PER_S
from study.problem import Problem
from study.tables import Table
from study.waiting import mean_wait_s

KEPT = Path(__file__).resolve().parent.parent.parent / "benchmarks" / "results"
"""What ./evoloop bench --json has written and the project keeps."""

ROWS = {
    "a whole conversion with threads, median": "an event follows at once on the one before",
    "button to command, added by us, median": "every thread has slept before, and a serial link lies between",
}
"""The rows of the benchmarks' table that are conversion times, and what they are measured under."""

CAPACITY = 9
"""What a converter holds by default: 8 events in the queue and one in the loop."""

_SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
_HELP = "give it a file that ./evoloop bench --json FILE wrote, all suites or --only running,device"


@dataclass(frozen=True)
class Measured:
    """A conversion time, the row that it stands in, and which run that is of."""

    conversion_s: float
    row: str
    run: str


def newest(folder: Path = KEPT) -> Path:
    """The file of the latest day in a folder of results; of several of one day the last by its name."""
    days = [(_load(path).get("day"), path) for path in folder.glob("*.json")]
    if not days:
        raise Problem(f"--measured: there are no results in {folder}; {_HELP}", status=2)
    return max(days, key=lambda day: (str(day[0]), day[1].name))[1]


def read(path: Path) -> list[Measured]:
    """The conversion times in a result file of the benchmarks, at least one."""
    results = _load(path)
    run = f"{path.name}, commit {results.get('commit')}"
    rows = results.get("rows")
    found = [row for row in rows if isinstance(row, dict) and row.get("what") in ROWS] if isinstance(rows, list) else []
    if not found:
        names = " and no row ".join(f"'{name}'" for name in ROWS)
        raise Problem(f"--measured: {path} has no row {names}; {_HELP}", status=2)
    return [Measured(_seconds(path, row), row["what"], run) for row in found]


def _load(path: Path) -> dict[str, Any]:
    try:
        results = json.loads(path.read_text(encoding="utf-8"))
    except OSError as cause:
        raise Problem(f"--measured: {path} cannot be read ({cause.strerror}); {_HELP}", status=2) from cause
    except ValueError as cause:
        raise Problem(f"--measured: {path} is not JSON ({cause}); {_HELP}", status=2) from cause
    return results if isinstance(results, dict) else {}


def _seconds(path: Path, row: dict[str, Any]) -> float:
    unit, value = row.get("unit"), row.get("ours")
    if unit not in _SECONDS or not isinstance(value, int | float) or not 0 < value < float("inf"):
        raise Problem(f"--measured: {path} gives {value} {unit} for '{row['what']}', not a time; {_HELP}", status=2)
    return value * _SECONDS[unit]


def measured_table(checker: Checker, times: list[Measured]) -> Table:
    """
    The paper's mechanism and ours at the measured conversion times, in the long run.

    What happens until 100 s is not asked: with conversions of microseconds that takes millions of steps.
    """
    header = ("row", "run", "conversion", "model", "K", "completion_s", "lost_per_s", "mean_wait_s")
    table = Table("measured", header)
    for measured in times:
        for model, own in (("exact", {}), ("fifo-serial", {"K": CAPACITY}), ("fifo-pipelined", {"K": CAPACITY})):
            constants = {"event_arrive": ARRIVALS_PER_S, "conversion": measured.conversion_s, **own}
            long_run = checker.check(model, "longrun", constants)
            table.add(
                measured.row,
                measured.run,
                measured.conversion_s,
                model,
                own.get("K"),
                long_run.value("completion"),
                long_run.value("lost_rate"),
                mean_wait_s(checker.check(model, "waiting", constants)),
            )
    return table
