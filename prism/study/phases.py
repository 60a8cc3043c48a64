"""
Conversion times as measured, as distributions of phases.

Results of the benchmarks keep the median and the 99th percentile. A Coxian distribution with both is fitted: conversions
that vary less than exponential times have phases of one length, and some have one more; of those that vary more, one in ten
has another phase, which is longer.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

from study.problem import Problem

_SLOW_SHARE = 0.1
_MOST_PHASES = 20
_LONGEST = 1e4


@dataclass(frozen=True)
class Phases:
    """A Coxian distribution, named as in phases.sm; times in seconds."""

    phases: int
    first: float
    more: float
    last: float

    @property
    def mean(self) -> float:
        return self.phases * self.first + self.more * self.last

    @property
    def variation(self) -> float:
        """The squared coefficient of variation; 1 for an exponential distribution, 0 for a constant."""
        variance = self.phases * self.first**2 + self.more * (2 - self.more) * self.last**2
        return variance / self.mean**2

    def over(self, time_s: float) -> float:
        """The probability of taking longer."""
        if self.last == self.first:
            x = time_s / self.first
            fewer, most = _erlang(self.phases, x), _erlang(self.phases + 1, x)
            return (1 - self.more) * fewer + self.more * most
        # One phase, and in some conversions a second one of a different length.
        soon, late = math.exp(-time_s / self.first), math.exp(-time_s / self.last)
        return (1 - self.more) * soon + self.more * (self.last * late - self.first * soon) / (self.last - self.first)

    def quantile(self, share: float) -> float:
        """The time within which this share of the conversions ends."""
        return _root(lambda time_s: 1 - self.over(time_s) - share, 0.0, 100 * (self.mean + self.last))

    def with_mean(self, mean: float) -> "Phases":
        """The same shape at another scale."""
        factor = mean / self.mean
        return Phases(self.phases, factor * self.first, self.more, factor * self.last)

    def constants(self) -> dict[str, float | int]:
        return {"phases": self.phases, "first": self.first, "more": self.more, "last": self.last}


def fit(median_s: float, percentile_s: float) -> Phases:
    """
    The distribution with this median and this 99th percentile.

    Raises Problem if the two are nearly equal or too far apart.
    """
    ratio = percentile_s / median_s
    if ratio > math.log(100) / math.log(2):
        if ratio > _ratio(Phases(1, 1.0, _SLOW_SHARE, _LONGEST)):
            raise Problem(f"a 99th percentile of {ratio:.0f} times the median is out of all proportion; measure again")
        longer = _root(lambda last: _ratio(Phases(1, 1.0, _SLOW_SHARE, last)) - ratio, 1.0 + 1e-9, _LONGEST)
        shape = Phases(1, 1.0, _SLOW_SHARE, longer)
    else:
        phases = next((k for k in range(1, _MOST_PHASES) if _ratio(Phases(k + 1, 1.0, 0.0, 1.0)) <= ratio), None)
        if phases is None:
            raise Problem(f"a 99th percentile of {ratio:.2f} times the median is hardly a distribution; measure again")
        more = _root(lambda share: ratio - _ratio(Phases(phases, 1.0, share, 1.0)), 0.0, 1.0)
        shape = Phases(phases, 1.0, more, 1.0)
    return shape.with_mean(shape.mean * median_s / shape.quantile(0.5))


def _ratio(shape: Phases) -> float:
    return shape.quantile(0.99) / shape.quantile(0.5)


def _erlang(phases: int, x: float) -> float:
    """The probability that the sum of this many exponential times of mean 1 exceeds x."""
    return math.exp(-x) * sum(x**done / math.factorial(done) for done in range(phases))


def _root(rising: Callable[[float], float], low: float, high: float) -> float:
    """Where the function is 0, by bisection."""
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if rising(middle) < 0 else (low, middle)
    return (low + high) / 2
