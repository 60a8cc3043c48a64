"""Small computations of the study's own."""

import unittest

from study.counting import root
from study.estimates import estimate, student


class NumbersTest(unittest.TestCase):
    def test_finds_roots(self) -> None:
        self.assertAlmostEqual(root(lambda x: x**3 - 2, 0, 8, 1e-7), 2 ** (1 / 3), places=6)
        with self.assertRaises(ValueError):
            root(lambda x: x + 1, 0, 1, 1e-7)

    def test_knows_students_distribution(self) -> None:
        # From tables.
        for degrees, quantile in ((30, 2.750), (99, 2.626), (1000, 2.581)):
            self.assertAlmostEqual(student(degrees), quantile, places=3)

    def test_intervals_hold_what_they_should(self) -> None:
        mean = estimate(100, 5.0, 1.0)
        self.assertTrue(mean.holds(5.26))
        self.assertFalse(mean.holds(5.27))
