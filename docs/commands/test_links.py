"""Every link between the project's Markdown files leads to an existing file and heading."""

from __future__ import annotations

import re
import unittest
from pathlib import Path

from test_commands import ROOT, documents

_FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
_LINK = re.compile(r"\]\(([^)\s]+)\)")
_HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)


def anchors(text: str) -> set[str]:
    """The anchors that GitHub makes from headings: lower case, hyphens for spaces, no other punctuation."""
    headings = _HEADING.findall(_FENCE.sub("", text))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


class LinksTest(unittest.TestCase):
    def test_links_lead_somewhere(self) -> None:
        files = documents() + sorted((ROOT / "docs" / "adr").glob("*.md"))
        for file in files:
            for link in _LINK.findall(_FENCE.sub("", file.read_text(encoding="utf-8"))):
                if link.startswith(("http:", "https:")):
                    continue
                path, _, anchor = link.partition("#")
                target = (file.parent / path).resolve() if path else file
                with self.subTest(file=str(file.relative_to(ROOT)), link=link):
                    self.assertTrue(target.exists(), "no such file")
                    if anchor:
                        self.assertIn(anchor, anchors(target.read_text(encoding="utf-8")))

    def test_every_page_can_be_reached_from_the_map(self) -> None:
        listed = (ROOT / "docs" / "README.md").read_text(encoding="utf-8")
        for file in (ROOT / "docs").glob("**/*.md"):
            name = file.relative_to(ROOT / "docs").as_posix()
            with self.subTest(file=name):
                self.assertTrue(name == "README.md" or f"({name}" in listed, "add it to docs/README.md")


if __name__ == "__main__":
    unittest.main()
