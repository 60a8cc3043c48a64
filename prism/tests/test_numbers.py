"""The study's own small computations."""

import tempfile
import unittest
from pathlib import Path

from study.counting import root
from study.estimates import estimate, student
from study.tables import Table


class NumbersTest(unittest.TestCase):
    def test_finds_roots(self) -> None:
        self.assertAlmostEqual(root(lambda x: x**3 - 2, 0, 8, 1e-7), 2 ** (1 / 3), places=6)
        with self.assertRaises(ValueError):
            root(lambda x: x + 1, 0, 1, 1e-7)

    def test_knows_students_distribution(self) -> None:
        # From published tables.
        for degrees, quantile in ((30, 2.750), (99, 2.626), (1000, 2.581)):
            self.assertAlmostEqual(student(degrees), quantile, places=3)

    def test_intervals_hold_what_they_should(self) -> None:
        mean = estimate(100, 5.0, 1.0)
        self.assertTrue(mean.holds(5.26))
        self.assertFalse(mean.holds(5.27))

    def test_tables_come_back_as_they_were_written(self) -> None:
        table = Table("any", ("a", "b", "c", "d", "e"))
        table.add("text, with comma", 8, 0.25, None, float("inf"))
        with tempfile.TemporaryDirectory() as folder:
            table.write(Path(folder))
            read = Table.read("any", Path(folder))
            self.assertIsNone(Table.read("other", Path(folder)))
        self.assertIsNotNone(read)
        self.assertEqual((read.header, read.rows), (table.header, table.rows))
