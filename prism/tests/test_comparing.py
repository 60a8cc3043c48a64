"""When a measurement shows that converter and model differ, and when it is chance."""

import tempfile
import unittest
from pathlib import Path

from study import experiment
from study.comparing import Comparison, failures
from study.estimates import NEVER, Estimate
from study.points import MODES, POINTS
from study.problem import Problem


def _off(errors: float, quantity: str = "wait_s") -> Comparison:
    """A comparison whose measurement is this many standard errors off."""
    return Comparison(MODES[0], POINTS[0], 1, quantity, 0, Estimate(2500, 1 + 0.01 * errors, 0.01), 1.0)


class ComparingTest(unittest.TestCase):
    def test_one_chance_miss_of_fifty_is_no_failure(self) -> None:
        comparisons = [_off(0.5)] * 49 + [_off(2.8)]
        self.assertEqual(sum(not one.holds() for one in comparisons), 1)
        self.assertEqual(failures(comparisons), [])

    def test_one_that_chance_does_not_explain_is(self) -> None:
        wrong = _off(4.5)
        self.assertEqual(failures([_off(0.5)] * 49 + [wrong]), [wrong])

    def test_the_more_are_compared_the_further_off_one_may_be(self) -> None:
        miss = _off(3.2)
        self.assertEqual(failures([miss]), [miss])
        self.assertEqual(failures([_off(0)] * 99 + [miss]), [])

    def test_never_is_a_value_of_its_own(self) -> None:
        for measured, model, holds in (
            (NEVER, float("inf"), True),
            (NEVER, 10.0, False),
            (Estimate(1, 10.0, 0.0), float("inf"), False),
            (Estimate(2500, 10.0, 1.0), float("inf"), False),
        ):
            one = Comparison(MODES[0], POINTS[0], 1, "divergence_s", 0, measured, model)
            with self.subTest(measured=measured, model=model):
                self.assertEqual(one.holds(), holds)
                self.assertEqual(failures([one] * 50) == [], holds)

    def test_tells_what_was_compared(self) -> None:
        longer = Comparison(MODES[1], POINTS[2], 1, "longer", 3, Estimate(100, 0.2, 0.01), 0.1)
        self.assertEqual(
            str(longer),
            "pipelined K=1, 0.25 s (threads): longer than 3 s: measured 0.2 ± 0.026, the model says 0.1",
        )
        self.assertIn("waiting time in s: measured 1.01", str(_off(1)))

    def test_refuses_measurements_of_another_version(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"{experiment.MEASUREMENTS}.csv"
            path.write_text("point,seed,quantity,t,n,mean,deviation\np,1,lost,5,2500,0.7,1.0\n")
            with self.assertRaisesRegex(Problem, "measure again with ./evoloop study --experiment"):
                experiment.load(Path(folder))
