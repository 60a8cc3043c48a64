"""The whole study, from models to report."""

from collections.abc import Callable
from pathlib import Path

from study import (
    belief,
    comparing,
    counting,
    curves,
    devices,
    disturbances,
    experiment,
    measured,
    plots,
    report,
    sensitivity,
    waiting,
)
from study.checking import Checker
from study.points import MODES
from study.predictions import Predictions
from study.proof import proving, section
from study.tables import Table

RESULTS = Path(__file__).resolve().parent.parent / "results"

Progress = Callable[[str], None]

_TABLES: dict[str, tuple[Callable[[Checker], Table], ...]] = {
    "counting losses exactly": (counting.counting_table, counting.break_even_table),
    "waiting times": (waiting.waiting_table, waiting.longer_table),
    "belief and device": (belief.belief_table,),
    "devices that make it harder": (devices.path_table, devices.holdoff_table),
    "disturbances": (disturbances.crash_table, disturbances.sight_table, disturbances.swap_table),
    "other arrivals and conversion times": (sensitivity.sensitivity_table,),
}


def study(checker: Checker, progress: Progress) -> list[comparing.Comparison]:
    """
    Checks every model and writes tables, plots and the report.

    Returns the comparison with the last experiment's measurements, empty if there are none.
    """
    RESULTS.mkdir(exist_ok=True)
    progress(f"the paper's properties, with {checker.name}")
    computed = curves.compute(checker)
    tables = [curves.curves_table(computed), curves.summary_table(computed)]
    for what, makers in _TABLES.items():
        progress(what)
        tables += [make(checker) for make in makers]
    by_name = {table.name: table for table in tables}
    found = report.Findings(checker.name, computed, by_name, counting.flagged_baseline(checker))
    progress("plots")
    plots.draw(RESULTS, computed, by_name)
    measurements = experiment.load(RESULTS)
    if measurements is not None:
        progress("the experiment's measurements beside the models")
        predictions = Predictions(checker, by_name["waiting-longer"])
        found.comparisons = comparing.compare(measurements, predictions)
        found.measured_events = {mode: measurements.least_events(mode) for mode in MODES}
        tables.append(comparing.comparison_table(found.comparisons))
        plots.draw_experiment(RESULTS, measurements, predictions)
    for table in tables:
        table.write(RESULTS)
    for name in (*measured.TABLES, *section.TABLES):
        kept = Table.read(name, RESULTS)
        if kept is not None:
            by_name[name] = kept
    report.write(RESULTS, found)
    return found.comparisons


def prove(progress: Progress) -> list[str]:
    """Checks the specification of the converter, for use in the report; returns the properties that do not hold."""
    RESULTS.mkdir(exist_ok=True)
    return proving.prove(RESULTS, progress)


def run_experiment(first_seed: int, progress: Progress) -> None:
    """Measures the converter again, for use in the report."""
    RESULTS.mkdir(exist_ok=True)
    experiment.measure(first_seed, progress).write(RESULTS)


def take_measured(checker: Checker, times: list[measured.Measured], progress: Progress) -> None:
    """Checks the models at measured conversion times, for use in the report."""
    RESULTS.mkdir(exist_ok=True)
    for one in times:
        progress(f"the measured conversion time, {one.conversion_s * 1e6:.1f} µs ({one.row}; {one.run})")
    measured.measured_table(checker, times).write(RESULTS)
    measured.phases_table(checker, times).write(RESULTS)
