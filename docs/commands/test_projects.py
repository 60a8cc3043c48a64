"""Projects of others, in Java and in Kotlin, build against the artifacts as ./evoloop install leaves them."""

from __future__ import annotations

import re
import shutil
import tempfile
import unittest
from pathlib import Path

from repository import Repository
from test_commands import ROOT, SLOW

PROJECTS = ("maven", "kotlin")
ARTIFACTS = ("bom", "core", "testkit")


@unittest.skipUnless(SLOW, "slow: ./evoloop test --slow runs it")
class ProjectsTest(unittest.TestCase):
    """In a local repository of their own, on top of what Maven has fetched for the project's own build."""

    @classmethod
    def setUpClass(cls) -> None:
        folder = tempfile.TemporaryDirectory(prefix="evoloop-projects-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.repository = Repository(cls.folder / "repository")
        cls.repository.install(*ARTIFACTS)

    def test_each_builds_and_passes_its_test(self) -> None:
        for name in PROJECTS:
            with self.subTest(project=name):
                project = self.folder / name
                shutil.copytree(ROOT / "docs" / "projects" / name, project)
                said = self.repository.maven(project / "pom.xml", "verify")
                self.assertRegex(said, re.compile(r"Tests run: 1, Failures: 0, Errors: 0, Skipped: 0$", re.MULTILINE))

    def test_the_core_brings_slf4j_and_nothing_else(self) -> None:
        project = self.folder / "tree"
        shutil.copytree(ROOT / "docs" / "projects" / "maven", project)
        goal = "org.apache.maven.plugins:maven-dependency-plugin:3.11.0:list"
        said = self.repository.maven(project / "pom.xml", goal, "-DincludeScope=runtime")
        self.assertEqual(
            set(re.findall(r"^\[INFO\]    (\S+?:\S+?):jar", said, re.MULTILINE)),
            {"org.evoloop:evoloop-core", "org.slf4j:slf4j-api"},
        )


if __name__ == "__main__":
    unittest.main()
