"""The conversion time of today's converter, from a benchmark, and what follows from it."""

import json
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from study.checking import Checker
from study.paper import ARRIVALS_PER_S, HORIZON_S
from study.problem import Problem
from study.tables import Table
from study.waiting import mean_wait_s

BENCHMARK = "EventPathBenchmark.threadsAfterPause"
METRIC = "eventPath"
"""From where a monitor has an event to where the execute component is called, every thread having slept before."""

CAPACITY = 9
"""What a converter holds by default: 8 events in the queue and one in the loop."""

_SECONDS = {"ns/op": 1e-9, "us/op": 1e-6, "ms/op": 1e-3, "s/op": 1.0}
_HELP = f"it is the file that ./evoloop bench --json FILE writes, with {BENCHMARK} and its metric {METRIC}"


@dataclass(frozen=True)
class Measured:
    """A mean conversion time and where it comes from."""

    conversion_s: float
    source: str


def read(path: Path) -> Measured:
    """The mean conversion time in a result file of JMH."""
    try:
        results = json.loads(path.read_text(encoding="utf-8"))
    except OSError as cause:
        raise Problem(f"--measured: {path} cannot be read ({cause.strerror}); {_HELP}", status=2) from cause
    except ValueError as cause:
        raise Problem(f"--measured: {path} is not JSON ({cause}); {_HELP}", status=2) from cause
    metric = _metric(results)
    if metric is None:
        raise Problem(f"--measured: {path} has no result of {BENCHMARK}; {_HELP}", status=2)
    unit, score = metric.get("scoreUnit"), metric.get("score")
    if unit not in _SECONDS or not isinstance(score, int | float) or not score > 0:
        raise Problem(f"--measured: {path} gives {score} {unit} for {METRIC}, not a time; {_HELP}", status=2)
    return Measured(score * _SECONDS[unit], f"{BENCHMARK}, {METRIC}")


def _metric(results: Any) -> dict[str, Any] | None:
    for result in results if isinstance(results, list) else []:
        if isinstance(result, dict) and str(result.get("benchmark", "")).endswith(BENCHMARK):
            for name, metric in result.get("secondaryMetrics", {}).items():
                # JMH marks what a profiler adds with a dot.
                if name.lstrip("·") == METRIC:
                    return metric
    return None


def run_benchmark(root: Path, tell: Callable[[str], None]) -> Measured:
    """Runs the benchmarks, roughly, and reads what they measured."""
    tell("running ./evoloop bench --quick for the conversion time")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "results.json"
        command = [str(root / "evoloop"), "bench", "--quick", "--json", str(path)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            why = (done.stderr.strip().splitlines() or [f"status {done.returncode}"])[-1]
            raise Problem(f"--measured: the benchmarks could not be run ({why}); give it a file: {_HELP}")
        return read(path)


def measured_table(checker: Checker, measured: Measured) -> Table:
    """The paper's mechanism and ours at the measured conversion time."""
    header = ("model", "K", "conversion", "source", "lost", "completion_s", "lost_per_s", "mean_wait_s")
    table = Table("measured", header)
    for model, own in (("exact", {}), ("fifo-serial", {"K": CAPACITY}), ("fifo-pipelined", {"K": CAPACITY})):
        constants = {"event_arrive": ARRIVALS_PER_S, "conversion": measured.conversion_s, **own}
        long_run = checker.check(model, "longrun", constants)
        table.add(
            model,
            own.get("K"),
            measured.conversion_s,
            measured.source,
            checker.check(model, "paper", {**constants, "T": HORIZON_S}).value("lost"),
            long_run.value("completion"),
            long_run.value("lost_rate"),
            mean_wait_s(checker.check(model, "waiting", constants)),
        )
    return table
