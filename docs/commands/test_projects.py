"""Projects of others, in Java and in Kotlin, with Maven and with Gradle, build against the artifacts as ./evoloop install leaves them."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from repository import Repository
from test_commands import LIMIT_S, ROOT, SLOW

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

    @unittest.skipUnless(shutil.which("gradle"), "there is no gradle")
    def test_gradle_builds_one_and_passes_its_test(self) -> None:
        for name in ("gradle", "maven"):
            shutil.copytree(ROOT / "docs" / "projects" / name, self.folder / "beside" / name)
        result = subprocess.run(
            ["gradle", "--no-daemon", f"-Dmaven.repo.local={self.repository.folder}", "build"],
            cwd=self.folder / "beside" / "gradle",
            capture_output=True,
            encoding="utf-8",
            timeout=LIMIT_S,
        )
        self.assertEqual(result.returncode, 0, result.stdout[-3000:] + result.stderr[-2000:])
        # Debian's Gradle starts JUnit's own console, later ones write what Maven writes.
        written = self.folder / "beside" / "gradle" / "build" / "test-results" / "test"
        passed = re.search(r"\b1 tests successful\b", result.stdout) or list(written.glob("TEST-*LampTest.xml"))
        self.assertTrue(passed, result.stdout[-3000:])

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
