"""No change to a model goes unnoticed: each mutant of each file breaks a pinned value, or there is a stated reason why it cannot."""

import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from study import checking, pinned
from study.problem import Problem
from study.storm import Storm
from tests.mutants import Mutant, mutants
from tests.survivors import SURVIVORS


class MutantsTest(unittest.TestCase):
    def test_every_mutant_is_noticed_or_explained(self) -> None:
        files = sorted((*checking.MODELS.glob("*.sm"), *checking.MODELS.glob("*.props")))
        self.assertTrue(files)
        used = set()
        for path in files:
            number = survived = 0
            for mutant in mutants(path.read_text(encoding="utf-8")):
                number += 1
                if self._is_noticed(path, mutant):
                    continue
                survived += 1
                reason = next((one for one in SURVIVORS if one.explains(path.name, mutant)), None)
                used.add(reason)
                with self.subTest(file=path.name, mutant=str(mutant)):
                    self.assertIsNotNone(reason, "not detected, and tests/survivors.py gives no reason")
            print(f"{path.name}: {number} mutants, {survived} of them explained or unnoticed", flush=True)
        for one in SURVIVORS:
            with self.subTest(explanation=one):
                self.assertIn(one, used, "explains no mutant that survives")

    @staticmethod
    def _is_noticed(path: Path, mutant: Mutant) -> bool:
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(checking.MODELS, folder, dirs_exist_ok=True)
            (Path(folder) / path.name).write_text(mutant.text, encoding="utf-8")
            with mock.patch.object(checking, "MODELS", Path(folder)):
                try:
                    return not all(one.holds() for one in pinned.check(Storm(), pinned.pins(path.stem)))
                except (Problem, KeyError):  # it cannot be read, built or checked
                    return True
