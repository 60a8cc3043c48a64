"""Users' projects, in Java and Kotlin, with Maven and Gradle, build against the artifacts of ./evoloop install."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import threading
import unittest
import zipfile
from pathlib import Path
from subprocess import PIPE, STDOUT

from repository import SCAFFOLDED, Repository
from test_commands import BUILDS_PROJECTS, LIMIT_S, ROOT

PROJECTS = ("maven", "kotlin")
MAVEN = Path("/usr/bin/mvn")
TOOL = ROOT / "framework" / "models" / "target" / "evoloop-models.jar"


@unittest.skipUnless(BUILDS_PROJECTS, "slow: ./evoloop test --slow runs it")
class ProjectsTest(unittest.TestCase):
    """In a separate local repository, on top of what Maven has fetched for the project's build."""

    @classmethod
    def setUpClass(cls) -> None:
        folder = tempfile.TemporaryDirectory(prefix="evoloop-projects-")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.repository = Repository(cls.folder / "repository")
        cls.repository.install(*SCAFFOLDED)

    def test_each_builds_and_passes_its_test(self) -> None:
        for name in PROJECTS:
            with self.subTest(project=name):
                project = self.folder / name
                shutil.copytree(ROOT / "docs" / "projects" / name, project)
                # Kotlin's daemon would outlive the test.
                said = self.repository.maven(project / "pom.xml", "verify", "-Dkotlin.compiler.daemon=false")
                self.assertRegex(said, re.compile(r"Tests run: 1, Failures: 0, Errors: 0, Skipped: 0$", re.MULTILINE))

    @unittest.skipUnless(MAVEN.exists(), "Debian's package maven is not installed")
    def test_what_the_documentation_prints_works_with_debians_maven(self) -> None:
        """As the POM of a project, and the project's own POM. This Maven has one local repository only."""
        repository = self.folder / "one"
        for part in (Path.home() / ".m2" / "repository", self.repository.folder):
            shutil.copytree(part, repository, dirs_exist_ok=True)
        page = (ROOT / "docs" / "artifacts.md").read_text(encoding="utf-8")
        printed = re.findall(r"^```xml\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)[0]
        names = "<groupId>com.example</groupId><artifactId>lamp</artifactId><version>1.0</version>"
        project = self.folder / "debian"
        shutil.copytree(ROOT / "docs" / "projects" / "maven", project)
        own = (project / "pom.xml").read_text(encoding="utf-8")
        for pom in (own, f"<project><modelVersion>4.0.0</modelVersion>{names}{printed}</project>"):
            with self.subTest(pom=pom):
                (project / "pom.xml").write_text(pom, encoding="utf-8")
                result = subprocess.run(
                    [MAVEN, "-B", f"-Dmaven.repo.local={repository}", "clean", "verify"],
                    cwd=project,
                    capture_output=True,
                    encoding="utf-8",
                    timeout=LIMIT_S,
                )
                self.assertEqual(result.returncode, 0, result.stdout[-3000:])
                self.assertRegex(result.stdout, re.compile(r"Tests run: 1, Failures: 0, Errors: 0, Skipped: 0$", re.MULTILINE))

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
        # Debian's Gradle starts JUnit's own console; later versions write the same as Maven.
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

    def test_a_scaffolded_project_becomes_one_jar_that_converts(self) -> None:
        robot, project = "models/cleaning-robot.xml", self.folder / "made"
        scaffold = ["scaffold", f"{robot}#original", f"{robot}#new", "--spontaneous", "endSpot", "--package", "com.example.made"]
        subprocess.run(["java", "-jar", TOOL, *scaffold, "--out", project], cwd=ROOT, check=True, capture_output=True, timeout=LIMIT_S)
        self.repository.maven(project / "pom.xml", "verify")
        jar = project / "target" / "made.jar"
        self.assertEqual(list(jar.parent.glob("*.jar")), [jar])

        said = self.converted_by(jar)
        for line in (" inputs Clean event.", "device in On"):
            self.assertIn(line, said)

        with zipfile.ZipFile(jar) as inside:
            self.assertIn("Apache License", inside.read("META-INF/LICENSE").decode())
            notice = inside.read("META-INF/NOTICE").decode()
            licences = " ".join(name for name in inside.namelist() if name.startswith("META-INF/licenses/"))
        for library in ("Evoloop", "ch.qos.logback"):
            self.assertIn(library, notice)
        for library in ("evoloop-core", "slf4j-api"):
            self.assertIn(library, licences)

    def converted_by(self, jar: Path) -> list[str]:
        """The output of a scaffolded program when its robot is on and should Move, a state that only its new model has."""
        command = ["java", "-jar", str(jar)]
        with subprocess.Popen(command, stdin=PIPE, stdout=PIPE, stderr=STDOUT, encoding="utf-8") as program:
            assert program.stdin and program.stdout
            watchdog = threading.Timer(LIMIT_S, program.kill)
            watchdog.start()
            program.stdin.write("start\npress Clean\npress Spot\n")
            program.stdin.flush()
            said = []
            while not (said and "***  Move  ***" in said[-1]):
                line = program.stdout.readline()
                self.assertTrue(line, f"it ended after {said}")
                said.append(line.rstrip("\n"))
            rest, _ = program.communicate("exit\n")
            watchdog.cancel()
        self.assertEqual(program.returncode, 0, rest)
        return said + rest.splitlines()


if __name__ == "__main__":
    unittest.main()
