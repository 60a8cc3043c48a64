"""Distributions of phases, fitted to a median and a 99th percentile."""

import math
import unittest

from study.phases import Phases, fit
from study.problem import Problem


class PhasesTest(unittest.TestCase):
    def test_has_what_was_measured(self) -> None:
        for median, percentile in ((14.231e-6, 188.287e-6), (307e-6, 1807e-6), (1.0, 2.0), (1.0, 6.7), (1.0, 60.0)):
            with self.subTest(median=median, percentile=percentile):
                fitted = fit(median, percentile)
                self.assertAlmostEqual(fitted.quantile(0.5) / median, 1, places=6)
                self.assertAlmostEqual(fitted.quantile(0.99) / percentile, 1, places=6)

    def test_more_than_exponential_is_rarely_long_and_less_is_of_equal_phases(self) -> None:
        bursty, steady = fit(1.0, 13.0), fit(1.0, 3.0)
        self.assertEqual((bursty.phases, bursty.more), (1, 0.1))
        self.assertGreater(bursty.last, 3 * bursty.first)
        self.assertGreater(bursty.variation, 2)
        self.assertGreater(steady.phases, 1)
        self.assertEqual(steady.last, steady.first)
        self.assertLess(steady.variation, 0.5)

    def test_knows_its_mean_and_variation(self) -> None:
        exponential = Phases(1, 3.0, 0.0, 3.0)
        self.assertEqual((exponential.mean, exponential.variation), (3.0, 1.0))
        self.assertAlmostEqual(exponential.over(3.0), math.exp(-1))
        self.assertAlmostEqual(Phases(4, 1.0, 0.0, 1.0).variation, 0.25)
        # Half of them last 1, half 1 and 3: the sum of the probabilities of lasting longer, times the step, is the mean.
        mixed = Phases(1, 1.0, 0.5, 3.0)
        step = 0.001
        times = [step * (index + 0.5) for index in range(80_000)]
        self.assertAlmostEqual(sum(step * mixed.over(time) for time in times), mixed.mean, places=4)
        square = sum(2 * step * time * mixed.over(time) for time in times)
        self.assertAlmostEqual(square / mixed.mean**2 - 1, mixed.variation, places=4)

    def test_keeps_its_shape_at_another_scale(self) -> None:
        fitted = fit(1.0, 13.0)
        self.assertAlmostEqual(fitted.with_mean(0.25).mean, 0.25)
        self.assertAlmostEqual(fitted.with_mean(0.25).variation, fitted.variation)

    def test_refuses_what_is_hardly_a_distribution(self) -> None:
        for percentile in (1.01, 1e6):
            with self.subTest(percentile=percentile), self.assertRaisesRegex(Problem, "measure again"):
                fit(1.0, percentile)
