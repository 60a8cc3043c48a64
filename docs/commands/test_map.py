"""The maps: docs/README.md names every page, and CONTRIBUTING.md's table of where to change what names what exists."""

from __future__ import annotations

import re
import unittest

from test_commands import ROOT

_SECTION = re.compile(r"^## Where do I change \.\.\.\?$(.*?)^## ", re.MULTILINE | re.DOTALL)
_NAME = re.compile(r"`([A-Z]\w+|[\w./-]+\.\w+|[a-z]+(?:[-/][a-z/-]+)?)`")


class MapTest(unittest.TestCase):
    def test_every_page_can_be_reached_from_the_map(self) -> None:
        listed = (ROOT / "docs" / "README.md").read_text(encoding="utf-8")
        for file in (ROOT / "docs").glob("**/*.md"):
            name = file.relative_to(ROOT / "docs").as_posix()
            with self.subTest(file=name):
                self.assertTrue(name == "README.md" or f"({name}" in listed, "add it to docs/README.md")

    def test_what_the_table_names_exists(self) -> None:
        section = _SECTION.search((ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8"))
        assert section
        places = [line.rsplit("|", 2)[1] for line in section[1].splitlines() if line.startswith("| ")]
        ripples = [line for line in section[1].splitlines() if not line.startswith("|")]
        sources = [path for path in ROOT.glob("*/**/src/main/**/*") if "target" not in path.parts]
        sources += [path for path in ROOT.glob("*/**/src/test/**/*Test.java") if "target" not in path.parts]
        known = {path.name.removesuffix(".java") for path in sources}
        named = [name for line in places + ripples for name in _NAME.findall(line)]
        self.assertGreater(len(named), 50)
        for name in named:
            with self.subTest(name=name):
                self.assertTrue(name in known or (ROOT / name).is_dir(), "correct the table in CONTRIBUTING.md")


if __name__ == "__main__":
    unittest.main()
