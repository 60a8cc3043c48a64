"""PRISM need not be installed: these tests cover its command line and the parsing of its log."""

import os
import stat
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from study.both import Both
from study.checking import Answers, Constants
from study.prism_tool import Prism, read_results
from study.problem import Problem

_LOG = """PRISM
=====
Building model...
Model constants: K=2,conversion=0.25

---------------------------------------------------------------------

Model checking: "probability": P=? [ F[T,T] emb_st=st_max ]
Property constants: T=5

Result: 1.5E-7 (value in the initial state)

---------------------------------------------------------------------

Model checking: "lost": R{"lost"}=? [ C<=T ]
Property constants: T=5

Value in the initial state: 0.25

Result: 0.25 (+/- 2.5E-7 estimated; rel err 1E-6)

---------------------------------------------------------------------

Model checking: "completion": R{"time"}=? [ F emb_st=st_max ]

Result: Infinity (value in the initial state)
"""


class _Fixed:
    def __init__(self, value: float) -> None:
        self.name = str(value)
        self._value = value

    def check(self, model: str, properties: str, constants: Constants) -> Answers:
        answers = Answers()
        answers.put("lost", {}, self._value)
        return answers


class PrismTest(unittest.TestCase):
    def test_reads_values_with_their_constants(self) -> None:
        constants = {"K": 2.0, "conversion": 0.25}
        self.assertEqual(
            list(read_results(_LOG)),
            [
                ("probability", {**constants, "T": 5.0}, 1.5e-7),
                ("lost", {**constants, "T": 5.0}, 0.25),
                ("completion", constants, float("inf")),
            ],
        )

    def test_lets_prism_count_through_equal_steps_only(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            log = self._command(folder, f'echo "$@" >>{folder}/calls\ncat {folder}/log')
            log.write_text(_LOG)
            with mock.patch.dict(os.environ, {"PATH": f"{folder}:{os.environ['PATH']}"}):
                answers = Prism().check("exact", "paper", {"event_arrive": 0.5, "K": (1, 2, 4), "T": (0, 5, 10)})
            calls = (Path(folder) / "calls").read_text().splitlines()
        self.assertEqual(answers.value("lost", K=2, T=5), 0.25)
        self.assertEqual([call.split()[-1] for call in calls], [
            "event_arrive=0.5,T=0:5:10,K=1", "event_arrive=0.5,T=0:5:10,K=2", "event_arrive=0.5,T=0:5:10,K=4",
        ])

    def test_passes_on_what_prism_complains_of(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            self._command(folder, "echo 'Error: Undefined constant K.'; exit 1")
            with mock.patch.dict(os.environ, {"PATH": f"{folder}:{os.environ['PATH']}"}):
                with self.assertRaisesRegex(Problem, r"exact\.sm .*PRISM says: Error: Undefined constant K\."):
                    Prism().check("exact", "paper", {"T": 5})

    def test_says_what_to_do_where_there_is_no_prism(self) -> None:
        with mock.patch.dict(os.environ, {"PATH": "/nonexistent"}), self.assertRaisesRegex(Problem, "--checker storm"):
            Prism()

    def test_both_remember_the_largest_difference(self) -> None:
        both = Both(_Fixed(1.0), _Fixed(2.0))
        self.assertEqual(both.check("any", "longrun", {}).value("lost"), 1.0)
        self.assertEqual(both.largest_difference, 0.5)
        both.check("any", "paper", {})
        self.assertEqual(both.largest_difference, 1.0)
        both.check("any", "longrun", {})
        self.assertEqual(both.largest_difference, 1.0)

    @staticmethod
    def _command(folder: str, script: str) -> Path:
        command = Path(folder) / "prism"
        command.write_text(f"#!/bin/sh\n{script}\n")
        command.chmod(command.stat().st_mode | stat.S_IXUSR)
        return Path(folder) / "log"
