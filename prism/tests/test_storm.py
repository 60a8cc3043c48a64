"""Storm on real models, and on broken ones."""

import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from study import checking
from study.problem import Problem
from study.storm import Storm, has_stormpy


@unittest.skipUnless(has_stormpy(), "stormpy is not installed; PRISM does without")
class StormTest(unittest.TestCase):
    def test_varies_constants_of_model_and_properties(self) -> None:
        answers = Storm().check("exact", "paper", {"event_arrive": 0.5, "conversion": (0.25, 1), "T": (0, 100)})
        self.assertEqual(answers.value("lost", conversion=1, T=0), 0)
        self.assertAlmostEqual(answers.value("lost", conversion=0.25, T=100), 17.266009, places=6)
        self.assertAlmostEqual(answers.value("lost", conversion=1, T=100), 22.009259, places=6)

    def test_says_never_for_what_cannot_be_reached(self) -> None:
        constants = {"event_arrive": 0.5, "conversion": 0.25, "K": 2, "T": 100}
        answers = Storm().check("fifo-pipelined", "belief", constants)
        self.assertEqual(answers.value("divergence"), float("inf"))
        self.assertEqual(answers.value("differed"), 0)

    def test_names_the_constant_without_a_value(self) -> None:
        with self.assertRaisesRegex(Problem, "conversion has no value"):
            Storm().check("exact", "longrun", {"event_arrive": 0.5})

    def test_names_the_model_file_that_is_broken_or_missing(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            models = Path(folder)
            shutil.copy(checking.property_file("longrun"), models)
            broken = {
                "x : [0..1] init 0 [] x=0 -> 1 : (x'=1);": 'expecting ";"',
                "x : [0..1] init 0; [] x=0 -> 1 : (y'=1);": "Unknown variable 'y'",
            }
            with mock.patch.object(checking, "MODELS", models):
                for body, reason in broken.items():
                    (models / "broken.sm").write_text(f"ctmc\nmodule M\n{body}\nendmodule\n")
                    with self.assertRaisesRegex(Problem, rf"broken\.sm with longrun\.props: .*{reason}"):
                        Storm().check("broken", "longrun", {})
                with self.assertRaisesRegex(Problem, r"absent\.sm is missing"):
                    Storm().check("absent", "longrun", {})
