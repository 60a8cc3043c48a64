"""Confidence intervals of measured means."""

from dataclasses import dataclass
from statistics import NormalDist

CONFIDENCE = 0.99
_FEW = 20


@dataclass(frozen=True)
class Estimate:
    """The mean of independent values, with the standard error and the number of values."""

    number: int
    mean: float
    error: float

    def half_width(self, confidence: float = CONFIDENCE) -> float:
        """Half the width of the mean's confidence interval; infinite if there are too few values."""
        return student(self.number - 1, confidence) * self.error if self.number > _FEW else float("inf")

    def holds(self, value: float, confidence: float = CONFIDENCE) -> bool:
        """Whether the interval holds the value. If it never happened, only "never" (infinity) is in it."""
        if float("inf") in (value, self.mean):
            return value == self.mean
        return abs(value - self.mean) <= self.half_width(confidence)

    def __str__(self) -> str:
        return "never" if self.mean == float("inf") else f"{self.mean:.4g} ± {self.half_width():.2g}"


NEVER = Estimate(0, float("inf"), 0.0)


def estimate(number: int, mean: float, deviation: float) -> Estimate:
    """The estimate from this many values with this mean and sample standard deviation."""
    return Estimate(number, mean, deviation / number**0.5)


def student(degrees: int, confidence: float = CONFIDENCE) -> float:
    """
    The two-sided quantile of Student's distribution.

    From 30 degrees of freedom on it is exact to three decimal places for a confidence of 0.99.
    """
    z, n = NormalDist().inv_cdf((1 + confidence) / 2), degrees
    return z + (z**3 + z) / (4 * n) + (5 * z**5 + 16 * z**3 + 3 * z) / (96 * n**2)
