"""What ./evoloop test prints of a run, in a project of two modules; Maven is replaced by a fake here."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from test_commands import LIMIT_S, ROOT

POM = '<project xmlns="http://maven.apache.org/POM/4.0.0"><name>{}</name>{}</project>\n'
MAVEN = """#!/bin/sh
for line in $(seq 1000); do echo "[INFO] line $line"; done
sh ./run
cat reactor
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


class SummaryTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.write("mvnw", MAVEN).chmod(0o755)
        for file in ("evoloop", ".ci/summary.py"):
            self.write(file, (ROOT / file).read_text(encoding="utf-8"))
        shutil.copymode(ROOT / "evoloop", self.root / "evoloop")
        self.write(".mvn/config", "")
        self.write("pom.xml", POM.format("House", "<modules><module>lamp</module>\n<module>door</module></modules>"))
        self.write("lamp/pom.xml", POM.format("The lamp", ""))
        self.write("door/pom.xml", POM.format("The door", ""))
        self.write("docs/commands/test_documented.py", DOCUMENTED.format(True))
        self.write("lamp/target/surefire-reports/TEST-OldTest.xml", GOOD)
        os.utime(self.root / "lamp/target/surefire-reports/TEST-OldTest.xml", (0, 0))

    def write(self, name: str, text: str) -> Path:
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        return file

    def maven(self, door: str, status: int, *more: str) -> None:
        """What Maven writes and prints in the next run."""
        for module, text in (("lamp", GOOD), ("door", door)):
            self.write(f"made/{module}.xml", text)
        moves = [f"mkdir -p {m}/target/surefire-reports; cp made/{m}.xml {m}/target/surefire-reports/TEST-{m}.xml" for m in ("lamp", "door")]
        self.write("run", "\n".join([*moves, "echo noise of the door >door/target/surefire-reports/door-output.txt"]))
        result = "FAILURE" if status else "SUCCESS"
        self.write(
            "reactor",
            f"[INFO] House .............. SUCCESS [  0.501 s]\n[INFO] The lamp ........... SUCCESS [01:16 min]\n"
            f"[INFO] The door ........... {result} [  7.200 s]\n[INFO] BUILD {result}\n" + "".join(f"{each}\n" for each in more),
        )
        self.write("mvnw", f"{MAVEN}exit {status}\n")

    def tested(self) -> tuple[int, list[str]]:
        result = subprocess.run(
            [self.root / "evoloop", "test"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", timeout=LIMIT_S
        )
        return result.returncode, [each for each in result.stdout.splitlines() if not each.startswith("evoloop: ")]

    def test_a_run_that_passes_is_a_line_for_each_module(self) -> None:
        self.maven(GOOD, 0)
        status, printed = self.tested()
        self.assertEqual(status, 0, printed)
        self.assertEqual([each.split()[0] for each in printed[:4]], ["parent", "lamp", "door", "documented"])
        self.assertRegex(printed[1], r"^lamp +3 tests +76 s$")
        self.assertEqual(printed[4:], ["Tests run: 7, Failures: 0, Errors: 0, Skipped: 2", "all tests and checks passed"])
        self.assertIn("line 1000", (self.root / "target/test.log").read_text(encoding="utf-8"))
        self.assertIn("test_works", (self.root / "target/documented-commands.log").read_text(encoding="utf-8"))

    def test_a_failed_test_prints_its_own_log(self) -> None:
        self.maven(BAD, 1, "[ERROR] There are test failures.")
        status, printed = self.tested()
        self.assertEqual(status, 1, printed)
        self.assertRegex(printed[2], r"^door +2 tests +7 s +FAILED$")
        self.assertEqual(
            printed[3:],
            [
                *("-- door: DoorTest.shuts", "java.lang.AssertionError: ajar", "\tat DoorTest.shuts"),
                *("-- the end of door/target/surefire-reports/door-output.txt", "noise of the door"),
                "Tests run: 5, Failures: 1, Errors: 0, Skipped: 1",
            ],
        )

    def test_another_failure_prints_mavens_errors(self) -> None:
        self.maven(GOOD, 1, "[ERROR] Door.java:[3,7] cannot find symbol", "[INFO] a word about nothing")
        status, printed = self.tested()
        self.assertEqual(status, 1, printed)
        self.assertEqual(printed[3], "[ERROR] Door.java:[3,7] cannot find symbol")
        self.assertTrue(printed[4].startswith("Tests run: 6, "), printed)

    def test_a_command_that_fails_prints_its_own_log(self) -> None:
        self.maven(GOOD, 0)
        self.write("docs/commands/test_documented.py", DOCUMENTED.format(False))
        status, printed = self.tested()
        self.assertEqual(status, 1, printed)
        self.assertRegex(printed[3], r"^documented commands +1 test +0 s +FAILED$")
        self.assertIn("AssertionError: False is not true", printed)
        self.assertEqual(printed[-1], "Tests run: 7, Failures: 1, Errors: 0, Skipped: 2")


if __name__ == "__main__":
    unittest.main()
