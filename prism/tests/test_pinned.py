"""The pinned values, and that an error in a model is reported by name."""

import shutil
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from study import checking, pinned
from study.storm import Storm, has_stormpy


class PinnedTest(unittest.TestCase):
    def test_every_model_and_properties_file_is_pinned(self) -> None:
        pins = pinned.pins()
        for suffix, names in (("sm", {pin.model for pin in pins}), ("props", {pin.properties for pin in pins})):
            files = {path.stem for path in checking.MODELS.glob(f"*.{suffix}")}
            self.assertEqual(names, files)

    def test_the_papers_figures_are_among_them(self) -> None:
        lost = {
            dict(pin.constants)["conversion"]: pin.value
            for pin in pinned.pins("listing")
            if pin.property == "lost" and dict(pin.constants)["T"] == 100
        }
        self.assertEqual(lost, {0.25: 10.601888, 0.5: 13.886889, 0.75: 16.681865, 1: 19.089013})

    @unittest.skipUnless(has_stormpy(), "stormpy is not installed; PRISM does without")
    def test_tells_what_a_changed_rate_changes(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(checking.MODELS, folder, dirs_exist_ok=True)
            path = Path(folder) / "listing.sm"
            text = path.read_text(encoding="utf-8").replace("lost           -> 1 :", "lost           -> 1.1 :")
            path.write_text(text, encoding="utf-8")
            with mock.patch.object(checking, "MODELS", Path(folder)):
                lines = pinned.report(list(pinned.check(Storm(), pinned.pins("listing"))))
        wrong = [line for line in lines if line.startswith("FAIL")]
        self.assertRegex(
            wrong[0],
            r"^FAIL listing\.sm with paper\.props, event_arrive=0\.5, conversion=0\.25, T=100: lost: "
            r"[\d.]+, pinned 10\.601888 \(the paper's Listing 3 as printed\)$",
        )
