"""The present converter's conversion time, from the benchmarks, and its consequences."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from study.checking import Checker
from study.paper import ARRIVALS_PER_S
from study.phases import Phases, fit
from study.problem import Problem
from study.tables import Table
from study.waiting import mean_wait_s

KEPT = Path(__file__).resolve().parent.parent.parent / "benchmarks" / "results"
"""The stored results of ./evoloop bench --json."""

ROWS = {
    "a whole conversion with threads, median": "each event follows immediately after the previous one",
    "button to command, added by us, median": "every thread was asleep before; includes a serial link",
}
"""The rows of the benchmarks' table that are conversion times, with the conditions of their measurement."""

PERCENTILES = ("button to command, added by us, 99th percentile", "button to command, 99th percentile")
"""The names, present and former, of the row with the button's 99th percentile; the other row contains its percentile itself."""

SLOWER_S = (0.25, 1.0)
"""Mean conversion times at which the measured spread matters: the paper's smallest and largest."""

CAPACITY = 9
"""A converter's default capacity: 8 events in the queue and one in the loop."""

TABLES = ("measured", "measured-phases")

_SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
_HELP = "give it a file that ./evoloop bench --json FILE wrote, all suites or --only running,device"


@dataclass(frozen=True)
class Measured:
    """A conversion time, with its row and its run."""

    conversion_s: float
    row: str
    run: str
    percentile_s: float | None = None
    """The 99th percentile, where the file has it."""


def newest(folder: Path = KEPT) -> Path:
    """The file of the latest day in a folder of results; of several files of that day, the last by name."""
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
    return [Measured(_seconds(path, row), row["what"], run, _percentile(path, row, rows)) for row in found]


def _percentile(path: Path, row: dict[str, Any], rows: list[Any]) -> float | None:
    if row["what"].startswith("button"):
        for one in rows:
            if isinstance(one, dict) and one.get("what") in PERCENTILES:
                return _seconds(path, one)
        return None
    peers = row.get("peers")
    p99 = peers.get("p99") if isinstance(peers, dict) else None
    return None if p99 is None else _seconds(path, {**row, "ours": p99})


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

    Values until 100 s are left out: with conversions of microseconds they take millions of steps.
    """
    header = ("row", "run", "conversion", "model", "K", "completion_s", "lost_per_s", "mean_wait_s")
    table = Table(TABLES[0], header)
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


def phases_table(checker: Checker, times: list[Measured]) -> Table:
    """The long-run effect of the measured spread compared with exponential times of the same mean, also for slower converters."""
    header = ("row", "median", "percentile", "phases", "first", "more", "last", "variation", "mean", "distribution")
    table = Table(TABLES[1], (*header, "completion_s", "lost_per_s", "mean_wait_s"))
    for measured in times:
        if measured.percentile_s is None:
            continue
        fitted = fit(measured.conversion_s, measured.percentile_s)
        for mean in (fitted.mean, *SLOWER_S):
            shape = fitted.with_mean(mean)
            for distribution, one in (("exponential", Phases(1, mean, 0.0, mean)), ("phases", shape)):
                constants = {"event_arrive": ARRIVALS_PER_S, "K": CAPACITY, **one.constants()}
                long_run = checker.check("phases", "longrun", constants)
                table.add(
                    measured.row,
                    measured.conversion_s,
                    measured.percentile_s,
                    *shape.constants().values(),
                    shape.variation,
                    mean,
                    distribution,
                    long_run.value("completion"),
                    long_run.value("lost_rate"),
                    mean_wait_s(checker.check("phases", "waiting", constants)),
                )
    return table
