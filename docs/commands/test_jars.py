"""The licences and notices in the built jars."""

from __future__ import annotations

import re
import unittest
from pathlib import Path
from zipfile import ZipFile

from test_commands import ROOT

MODULES = re.findall("<module>(.*)</module>", (ROOT / "pom.xml").read_text(encoding="utf-8").split("<profiles>")[0])
GIVEN_AWAY = (
    "roomba-converter/target/roomba-converter.jar",
    "framework/models/target/evoloop-models.jar",
    "lightbulb-example/target/lightbulb-example.jar",
)
_ENTRY = re.compile(r"^  ([a-z0-9]+(?:\.\w+)*)  +\S", re.MULTILINE)


def jars() -> list[Path]:
    """The jars that every build makes, except that of this machine's OpenCV, which is never distributed."""
    modules = [ROOT / module / "target" for module in MODULES if module != "roomba-converter/opencv-debian"]
    found = (jar for module in modules for jar in module.glob("*.jar"))
    return sorted(jar for jar in found if not re.search("^original-|-(sources|javadoc)[.]jar$", jar.name))


def packages(jar: Path) -> set[str]:
    with ZipFile(jar) as inside:
        names = (re.sub(r"^META-INF/versions/\d+/", "", name) for name in inside.namelist())
        return {name.rpartition("/")[0].replace("/", ".") for name in names if name.endswith(".class")}


class JarsTest(unittest.TestCase):
    def test_every_jar_carries_licence_and_notice(self) -> None:
        self.assertTrue(jars(), "nothing was built")
        for jar in jars():
            with ZipFile(jar) as inside:
                for name in ("LICENSE", "NOTICE"):
                    with self.subTest(jar=jar.name, file=name):
                        self.assertEqual(inside.read(f"META-INF/{name}"), (ROOT / name).read_bytes())

    def test_the_notice_names_what_the_runnable_jars_contain_and_nothing_else(self) -> None:
        noticed = _ENTRY.findall((ROOT / "NOTICE").read_text(encoding="utf-8"))
        found: set[str] = set()
        for name in GIVEN_AWAY:
            for package in packages(ROOT / name):
                if package == "" or f"{package}.".startswith("org.evoloop."):
                    continue
                owners = {entry for entry in noticed if f"{package}.".startswith(f"{entry}.")}
                with self.subTest(jar=name, package=package):
                    self.assertEqual(len(owners), 1, "add it to NOTICE, with its licence")
                found |= owners
        self.assertEqual(set(noticed) - found, set(), "no jar contains these; remove them from NOTICE")

    def test_the_libraries_of_a_runnable_jar_bring_their_licences_along(self) -> None:
        for name in GIVEN_AWAY:
            with ZipFile(ROOT / name) as inside, self.subTest(jar=name):
                licences = [entry for entry in inside.namelist() if entry.startswith("META-INF/licenses/slf4j-api-")]
                self.assertTrue(any(entry.endswith("/LICENSE.txt") for entry in licences), licences)

    def test_no_jdk_warns_of_the_libraries_that_a_runnable_jar_loads(self) -> None:
        for name in (*GIVEN_AWAY, "fleet/target/fleet.jar"):
            with ZipFile(ROOT / name) as inside, self.subTest(jar=name):
                self.assertIn(b"\r\nEnable-Native-Access: ALL-UNNAMED\r\n", inside.read("META-INF/MANIFEST.MF"))


if __name__ == "__main__":
    unittest.main()
