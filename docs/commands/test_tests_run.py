"""What ./evoloop test prints of a run, in a project of two modules; Maven is replaced by a fake here."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from test_commands import LIMIT_S, ROOT

POM = '<project xmlns="http://maven.apache.org/POM/4.0.0"><artifactId>{}</artifactId><version>1</version>{}</project>\n'
MAVEN = """#!/bin/sh
# Builds, or tests one module as its file "run" says.
for line in $(seq 1000); do echo "[INFO] line $line"; done
module= tests=yes
while [ $# -gt 0 ]; do
  case "$1" in
    -pl) module=$2 ;;
    -DskipTests) tests= ;;
  esac
  shift
done
[ -n "$tests" ] || { mkdir -p lamp/target door/target; touch lamp/target/lamp-1.jar; exit 0; }
[ -f target/repository/org/evoloop/lamp/1/lamp-1.jar ] || exit 1
. "./$module/run"
"""
GOOD = '<testsuite tests="3" errors="0" skipped="1" failures="0"><testcase classname="LampTest" name="shines"/></testsuite>'
BAD = (
    '<testsuite tests="2" errors="0" skipped="0" failures="1"><testcase classname="DoorTest" name="opens"/>'
    '<testcase classname="DoorTest" name="shuts"><failure message="ajar">java.lang.AssertionError: ajar\n\tat DoorTest.shuts'
    "</failure></testcase></testsuite>"
)
DOCUMENTED = """import unittest
class Test(unittest.TestCase):
    def test_works(self):
        self.assertTrue({})
"""


class TestsRunTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.write("mvnw", MAVEN).chmod(0o755)
        for file in ("evoloop", ".ci/tests.py"):
            self.write(file, (ROOT / file).read_text(encoding="utf-8"))
        shutil.copymode(ROOT / "evoloop", self.root / "evoloop")
        shutil.copytree(ROOT / "scripts", self.root / "scripts")
        self.write(".mvn/config", "")
        self.write("pom.xml", POM.format("house", "<modules><module>lamp</module>\n<module>door</module></modules>"))
        for module in ("lamp", "door"):
            self.write(f"{module}/pom.xml", POM.format(module, ""))
            self.write(f"{module}/src/test/Test.java", "")
        self.write("docs/commands/test_documented.py", DOCUMENTED.format(True))
        self.write("lamp/target/surefire-reports/TEST-OldTest.xml", GOOD)
        os.utime(self.root / "lamp/target/surefire-reports/TEST-OldTest.xml", (0, 0))

    def write(self, name: str, text: str) -> Path:
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        return file

    def maven(self, module: str, report: str, status: int, said: str = "") -> None:
        """What a module's Maven writes and prints in the next run."""
        reports = f"{module}/target/surefire-reports"
        self.write(f"made/{module}.xml", report)
        self.write(
            f"{module}/run",
            f"mkdir -p {reports}; cp made/{module}.xml {reports}/TEST-{module}.xml; echo noise of the {module} >{reports}/{module}-output.txt\n"
            f"echo '{said}'; exit {status}\n",
        )

    def outcome(self) -> tuple[int, list[str]]:
        result = subprocess.run(
            [self.root / "evoloop", "test"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", timeout=LIMIT_S
        )
        return result.returncode, [each for each in result.stdout.splitlines() if not each.startswith("evoloop: ")]

    def test_a_run_that_passes_is_a_line_for_each_module(self) -> None:
        self.maven("lamp", GOOD, 0)
        self.maven("door", GOOD, 0)
        status, printed = self.outcome()
        self.assertEqual(status, 0, printed)
        self.assertEqual(sorted(each.split()[0] for each in printed[:2]), ["door", "lamp"])
        self.assertRegex(printed[0], r"^(lamp|door) +3 tests +0 s$")
        self.assertRegex(printed[2], r"^documented commands +1 test +0 s$")
        self.assertEqual(printed[3:], ["Tests run: 7, Failures: 0, Errors: 0, Skipped: 2", "all tests and checks passed"])
        for log in ("target/build.log", "lamp/target/test.log"):
            self.assertIn("line 1000", (self.root / log).read_text(encoding="utf-8"))
        self.assertIn("test_works", (self.root / "target/documented-commands.log").read_text(encoding="utf-8"))

    def test_a_failed_test_prints_its_own_log(self) -> None:
        self.maven("lamp", GOOD, 0)
        self.maven("door", BAD, 1, "[ERROR] There are test failures.")
        status, printed = self.outcome()
        self.assertEqual(status, 1, printed)
        failed = next(place for place, each in enumerate(printed) if each.startswith("door"))
        self.assertRegex(printed[failed], r"^door +2 tests +0 s  FAILED$")
        self.assertEqual(
            printed[failed + 1 : failed + 6],
            [
                *("-- door: DoorTest.shuts", "java.lang.AssertionError: ajar", "\tat DoorTest.shuts"),
                *("-- the end of door/target/surefire-reports/door-output.txt", "noise of the door"),
            ],
        )
        self.assertEqual(printed[-1], "Tests run: 5, Failures: 1, Errors: 0, Skipped: 1")

    def test_another_failure_prints_mavens_errors_and_hides_no_other(self) -> None:
        self.maven("lamp", BAD, 1)
        self.maven("door", GOOD, 1, "[ERROR] too little of the door is covered\n[INFO] a word about nothing")
        status, printed = self.outcome()
        self.assertEqual(status, 1, printed)
        self.assertIn("-- lamp: DoorTest.shuts", printed)
        self.assertIn("[ERROR] too little of the door is covered", printed)
        self.assertNotIn("[INFO] a word about nothing", printed)
        self.assertTrue(printed[-1].startswith("Tests run: 5, "), printed)

    def test_what_cannot_be_built_is_not_tested(self) -> None:
        self.write("mvnw", "#!/bin/sh\necho '[ERROR] Door.java:[3,7] cannot find symbol'\nexit 1\n").chmod(0o755)
        status, printed = self.outcome()
        self.assertEqual((status, printed), (1, ["[ERROR] Door.java:[3,7] cannot find symbol"]))

    def test_a_command_that_fails_prints_its_own_log(self) -> None:
        self.maven("lamp", GOOD, 0)
        self.maven("door", GOOD, 0)
        self.write("docs/commands/test_documented.py", DOCUMENTED.format(False))
        status, printed = self.outcome()
        self.assertEqual(status, 1, printed)
        self.assertRegex(printed[2], r"^documented commands +1 test +0 s  FAILED$")
        self.assertIn("AssertionError: False is not true", printed)
        self.assertEqual(printed[-1], "Tests run: 7, Failures: 1, Errors: 0, Skipped: 2")


if __name__ == "__main__":
    unittest.main()
