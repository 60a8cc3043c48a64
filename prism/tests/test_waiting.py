"""Two ways of computing the waiting time must agree."""

import unittest

from study import waiting
from study.storm import Storm, has_stormpy


@unittest.skipUnless(has_stormpy(), "stormpy is not installed; PRISM does without")
class WaitingTest(unittest.TestCase):
    def test_the_wait_model_agrees_with_littles_law(self) -> None:
        storm = Storm()
        for kind, stages in waiting.STAGES.items():
            with self.subTest(kind):
                constants = {"event_arrive": 0.5, "conversion": 0.5, "K": 2}
                little = waiting.mean_wait_s(storm.check(f"fifo-{kind}", "waiting", constants))
                places = {"found_waiting": (0, 1, 2), "found_stage": stages}
                found = storm.check(f"fifo-{kind}", "found", {**constants, **places})
                # Simpson's rule over the probability of waiting longer than t, which is negligible beyond 40 s.
                steps, width = 1600, 40 / 1600
                times = tuple(round(index * width, 6) for index in range(steps + 1))
                asked = {"conversion": 0.5, "ahead": (0, 1), "stage": stages, "t": times}
                ways = storm.check(f"wait-{kind}", "wait", asked)
                total = taken = 0.0
                for ahead in (0, 1):
                    for stage in stages:
                        share = found.value("found", found_waiting=ahead, found_stage=stage)
                        taken += share
                        for index, time in enumerate(times):
                            weight = 1 if index in (0, steps) else 4 if index % 2 else 2
                            over = ways.value("handed_over", ahead=ahead, stage=stage, t=time)
                            total += share * weight * (1 - over) * width / 3
                self.assertAlmostEqual(total / taken, little, places=5)
