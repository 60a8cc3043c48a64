"""Compares the running converter with the models that describe it."""

from dataclasses import dataclass

from study.estimates import Estimate
from study.experiment import Measurements
from study.points import MEASURED, Mode, Point
from study.predictions import QUANTITIES, TAIL, Predictions
from study.tables import Table

_FALSE_ALARM = 0.01
"""The probability that a run fails although the converter agrees with its models."""


@dataclass(frozen=True)
class Comparison:
    """One measured quantity beside the model's value."""

    mode: Mode
    point: Point
    seed: int
    quantity: str
    time_s: int
    measured: Estimate
    model: float

    def holds(self) -> bool:
        return self.measured.holds(self.model)

    def __str__(self) -> str:
        quantity = f"{QUANTITIES.get(self.quantity, 'longer than')}{f' {self.time_s} s' if self.quantity == TAIL else ''}"
        return f"{self.point.name} ({self.mode.name}): {quantity}: measured {self.measured}, the model says {self.model:.6g}"


def failures(comparisons: list[Comparison]) -> list[Comparison]:
    """
    The comparisons whose difference chance does not explain.

    Of many 99 % intervals some miss by chance. A value fails if it lies outside an interval so wide that the
    probability that any of them misses is 1 % at most, however they depend on each other (Bonferroni).
    """
    confidence = 1 - _FALSE_ALARM / max(1, len(comparisons))
    return [one for one in comparisons if not one.measured.holds(one.model, confidence)]


def compare(measurements: Measurements, predictions: Predictions) -> list[Comparison]:
    return [
        Comparison(
            mode,
            point,
            measurements.seed(mode, point),
            quantity,
            time_s,
            measurements.estimate(mode, point, quantity, time_s),
            model,
        )
        for mode, point in MEASURED
        for quantity, time_s, model in predictions.quantities(mode, point)
    ]


def comparison_table(comparisons: list[Comparison]) -> Table:
    header = ("mode", "point", "seed", "quantity", "t", "n", "measured", "half_width_99", "model", "holds")
    table = Table("experiment", header)
    failed = failures(comparisons)
    for one in comparisons:
        table.add(
            one.mode.name,
            one.point.name,
            one.seed,
            one.quantity,
            one.time_s,
            one.measured.number,
            one.measured.mean,
            one.measured.half_width(),
            one.model,
            "yes" if one.holds() else "no" if one in failed else "but for chance",
        )
    return table
