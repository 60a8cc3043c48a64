"""The proof's tools, and, where Spin is installed, that the specification does what the core does."""

import os
import shutil
import tempfile
import unittest
import unittest.mock
import xml.etree.ElementTree
from pathlib import Path

from study.problem import Problem
from study.proof import plan, script, section, sequence, spin, story

_GOLDEN = spin.SPECIFICATION / "golden"
_HAS_SPIN = shutil.which("spin") is not None and shutil.which("gcc") is not None

_NAMES = sequence.Names({1: "off", 2: "on"}, {1: "off", 2: "on"}, {1: "switch", 2: "timeout"})
_TRAIL = """> opened
= 1 1 1 0 0 0 0 0 doubt 0 0 0 0 work 0 0 0 0 0 0 [0 0 0 0 0 0 0 0 0 0]
device 1
the device does 1 by itself
= 1 1 1 0 0 0 0 0 doubt 0 0 0 0 work 0 0 0 0 0 0 [0 0 0 0 0 0 0 0 0 0]
device 2
> own 1 1
new 1
= 1 1 1 0 0 0 0 0 doubt 0 0 0 0 work 0 0 0 0 0 0 [0 0 0 0 0 0 0 0 0 0] [1 1 1 2 0 1 2 0 1 0]
device 2
violated 1"""


class TrailsTest(unittest.TestCase):
    def test_a_story_has_only_what_the_core_is_told(self) -> None:
        self.assertEqual(
            story.write(_TRAIL, _NAMES),
            "opened\n= open off off sure waiting 0 idle visit - -\n"
            "own switch acted\n= open off off sure waiting 1 idle visit - -\n",
        )

    def test_a_diagram_shows_both_sides_and_what_is_violated(self) -> None:
        drawn = sequence.draw(_TRAIL, _NAMES, "facts < presses", "record")
        texts = [text.text for text in xml.etree.ElementTree.fromstring(drawn).iter("{http://www.w3.org/2000/svg}text")]
        self.assertIn("facts < presses", texts)
        self.assertIn("did switch by itself", texts)
        self.assertIn("the record: device in off, system in off", texts)
        self.assertIn("in on", texts)
        self.assertIn(f"violated: {plan.PROPERTIES['record']}", texts)

    def test_steps_are_counted(self) -> None:
        self.assertEqual(sequence.steps(_TRAIL), 3)


class SectionTest(unittest.TestCase):
    def test_says_how_to_prove_it_first(self) -> None:
        self.assertIn("study --proof", section.proof({}))


class SpinTest(unittest.TestCase):
    def test_says_how_to_get_what_is_missing(self) -> None:
        with unittest.mock.patch.dict(os.environ, {"PATH": ""}), self.assertRaises(Problem) as missing:
            spin.require()
        self.assertRegex(str(missing.exception), "needs spin and gcc: .*apt-get install spin gcc")

    @unittest.skipUnless(_HAS_SPIN, "needs Spin")
    def test_the_specification_does_what_the_core_does(self) -> None:
        for pair in plan.PAIRS:
            with self.subTest(pair.name):
                inputs, difference = self._compare(pair, self._trace(pair))
                self.assertEqual(difference, "")
                self.assertGreater(inputs, 500)

    @unittest.skipUnless(_HAS_SPIN, "needs Spin")
    def test_the_specification_goes_the_ways_of_exploration(self) -> None:
        for pair in plan.PAIRS:
            told = (_GOLDEN / f"{pair.key}.stories.txt").read_text(encoding="utf-8")
            with self.subTest(pair.name), tempfile.TemporaryDirectory() as folder:
                inputs, difference = script.follows(Path(folder), self._tables(pair), told)
                self.assertEqual(difference, "")
                self.assertGreater(inputs, 500)

    @unittest.skipUnless(_HAS_SPIN, "needs Spin")
    def test_the_specification_goes_the_way_of_a_recorded_run(self) -> None:
        told = (_GOLDEN / "bulb.recorded.txt").read_text(encoding="utf-8")
        # The program's queue has LoopConfig's default capacity.
        roomy = self._tables(plan.BULB).replace("#define CAPACITY 2", "#define CAPACITY 8")
        with tempfile.TemporaryDirectory() as folder:
            inputs, difference = script.accepted(Path(folder), roomy, told)
        self.assertEqual(difference, "")
        self.assertGreater(inputs, 50)
        self.assertIn("> RECOVERED", told)

    @unittest.skipUnless(_HAS_SPIN, "needs Spin")
    def test_another_core_is_noticed(self) -> None:
        trace = self._trace(plan.BULB)
        place = trace.index("\n= 1 2 ", len(trace) // 2)
        _, difference = self._compare(plan.BULB, f"{trace[:place]}\n= 1 1 {trace[place + 7:]}")
        self.assertIn("the specification: = 1 2 ", difference)

    @unittest.skipUnless(_HAS_SPIN, "needs Spin")
    def test_a_mechanism_that_is_missing_is_noticed(self) -> None:
        mutant = next(one for one in plan.MUTANTS if one.name == "GIVING_UP_LEAVES_NO_DOUBT")
        with tempfile.TemporaryDirectory() as folder:
            defined = (*mutant.adapter.definitions, f"-D{mutant.name}")
            found = spin.search(Path(folder), self._tables(mutant.pair), mutant.acts, defined, mutant.broken)
        self.assertEqual(found.broken, "record")
        self.assertIn("> given_up", found.trail)

    def _compare(self, pair: plan.Pair, trace: str) -> tuple[int, str]:
        with tempfile.TemporaryDirectory() as folder:
            return script.accepted(Path(folder), self._tables(pair), trace)

    @staticmethod
    def _tables(pair: plan.Pair) -> str:
        return (_GOLDEN / f"{pair.key}.tables.pml").read_text(encoding="utf-8")

    @staticmethod
    def _trace(pair: plan.Pair) -> str:
        return (_GOLDEN / f"{pair.key}.trace.txt").read_text(encoding="utf-8")
