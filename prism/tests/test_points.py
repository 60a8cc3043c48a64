"""The measured points, and how they are passed to the experiment."""

import unittest

from study import experiment
from study.points import MEASURED, POINTS


class PointsTest(unittest.TestCase):
    def test_nothing_disturbs_threads(self) -> None:
        disturbed = {point.name for mode, point in MEASURED if mode.name == "threads" and point.disturbed}
        self.assertEqual(disturbed, set())
        self.assertEqual({point.name for mode, point in MEASURED if mode.name == "steps"}, {one.name for one in POINTS})

    def test_every_constant_of_a_point_reaches_the_experiment(self) -> None:
        for point in POINTS:
            cells = experiment._line(point, 7).strip("\n").split(",")
            with self.subTest(point.name):
                self.assertEqual(len(cells), 10)
                told = {cells[2], cells[3], cells[5], cells[6], cells[7], *(one.partition("=")[2] for one in cells[9].split())}
                self.assertLessEqual({str(value) for value in point.constants.values()}, told)
