"""The words of the exported types: no simple name means two things, in whichever module."""

from __future__ import annotations

import re
import unittest
from collections.abc import Iterator
from pathlib import Path

from test_commands import ROOT

_EXPORTED = re.compile(r"exports\s+([\w.]+)\s*;")
_TYPE = re.compile(r"^( {4})?((?:\w+ )*)(?:class|interface|record|enum|@interface) (\w+)", re.MULTILINE)


def exported() -> Iterator[tuple[str, str]]:
    """The simple and the full name of each type, nested ones included, that other modules may use."""
    for descriptor in ROOT.glob("*/**/src/main/java/module-info.java"):
        for package in _EXPORTED.findall(descriptor.read_text(encoding="utf-8")):
            for file in (descriptor.parent / package.replace(".", "/")).glob("*.java"):
                yield from types(package, file)


def types(package: str, file: Path) -> Iterator[tuple[str, str]]:
    found = [match.groups() for match in _TYPE.finditer(file.read_text(encoding="utf-8"))]
    outer = next((name for nested, modifiers, name in found if not nested and "public" in modifiers), None)
    if outer is None:
        return
    yield outer, f"{package}.{outer}"
    for nested, modifiers, name in found:
        if nested and "public" in modifiers:
            yield name, f"{package}.{outer}.{name}"


class NamesTest(unittest.TestCase):
    def test_no_exported_name_means_two_things(self) -> None:
        """Nested types may share a name with each other: they are read with that of the type around them."""
        meanings: dict[str, list[str]] = {}
        for simple, full in exported():
            meanings.setdefault(simple, []).append(full)
        self.assertGreater(len(meanings), 300)
        twice = {
            simple: sorted(fulls)
            for simple, fulls in meanings.items()
            if len(fulls) > 1 and any(full.rsplit(".", 2)[1][0].islower() for full in fulls)
        }
        self.assertEqual(twice, {}, "give one of them a name of its own")


if __name__ == "__main__":
    unittest.main()
