"""Confidence intervals of measured means."""

from dataclasses import dataclass
from statistics import NormalDist

CONFIDENCE = 0.99
_Z = NormalDist().inv_cdf((1 + CONFIDENCE) / 2)


@dataclass(frozen=True)
class Estimate:
    """The mean of independent values, with half the width of its confidence interval."""

    mean: float
    half_width: float

    def holds(self, value: float) -> bool:
        return value == self.mean or abs(value - self.mean) <= self.half_width

    def __str__(self) -> str:
        return "never" if self.mean == float("inf") else f"{self.mean:.4g} ± {self.half_width:.2g}"


def estimate(number: int, mean: float, deviation: float) -> Estimate:
    """The estimate from so many values with this mean and sample standard deviation."""
    return Estimate(mean, student(number - 1) * deviation / number**0.5)


def student(degrees: int) -> float:
    """The two-sided quantile of Student's distribution, to three digits after the point from 30 degrees of freedom on."""
    z, n = _Z, degrees
    return z + (z**3 + z) / (4 * n) + (5 * z**5 + 16 * z**3 + 3 * z) / (96 * n**2)
