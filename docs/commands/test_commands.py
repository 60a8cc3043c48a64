"""Every command in the documentation works; ./evoloop test runs this in a copy of the project."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from known import CAMERA, KNOWN, ROBOT, Known
from markdown import commands

ROOT = Path(__file__).resolve().parents[2]
SLOW = os.environ.get("EVOLOOP_COMMANDS") == "slow"
BUILDS_PROJECTS = SLOW or os.environ.get("EVOLOOP_COMMANDS") == "ci"
DUE = [entry for entry in KNOWN if entry.run and entry.slow == SLOW]
LIMIT_S = 3_600 if SLOW else 300
NOT_COPIED = (
    *(".git", "surefire-reports", "__pycache__", "repository", "interop-venv", "oracles-venv", "oracles-node", "site-venv"),
    *("home-assistant-root", "package-roots", "fresh-roots"),
    *(() if SLOW else (".venv",)),
)


def documents() -> list[Path]:
    files = [ROOT / name for name in ("README.md", "CONTRIBUTING.md")]
    for folder in ("docs", "models", "prism", "benchmarks"):
        files += sorted((ROOT / folder).glob("*.md"))
    return files


class MarkdownTest(unittest.TestCase):
    def test_commands_are_found_in_blocks_and_in_sentences(self) -> None:
        text = (
            "Type `./evoloop\nbench --quick`, not `./evoloop` or `java`:\n\n"
            "    ./evoloop models show a.xml#new   # a picture\n"
            "    X=1 ./mvnw -pl framework \\\n        test\n\n"
            "```sh\n./evoloop study --check\nls\n```\n"
        )
        self.assertEqual(
            set(commands(text)),
            {
                "./evoloop bench --quick",
                "./evoloop models show a.xml#new",
                "X=1 ./mvnw -pl framework test",
                "./evoloop study --check",
            },
        )


class KnownTest(unittest.TestCase):
    def test_every_documented_command_is_known_and_every_known_one_documented(self) -> None:
        known = [entry.documented for entry in KNOWN]
        self.assertEqual(sorted(known), sorted(set(known)), "one entry each")
        for file in documents():
            for command in commands(file.read_text(encoding="utf-8")):
                with self.subTest(file=file.relative_to(ROOT), command=command):
                    self.assertIn(command, known, "add it to docs/commands/known.py")
        documented = {command for file in documents() for command in commands(file.read_text(encoding="utf-8"))}
        self.assertEqual(set(known) - documented, set(), "documented nowhere; remove it from docs/commands/known.py")

    def test_each_is_run_or_there_is_a_reason(self) -> None:
        for entry in KNOWN:
            with self.subTest(command=entry.documented):
                self.assertNotEqual(bool(entry.run), bool(entry.why_not))


class HelpTest(unittest.TestCase):
    """What the scripts do themselves is explained on a machine where nothing is installed and nothing was built."""

    def test_help_comes_at_once(self) -> None:
        with tempfile.TemporaryDirectory(prefix="evoloop-help-") as name:
            folder = Path(name)
            tools = folder / "bin"
            tools.mkdir()
            for tool in ("bash", "cat", "dirname", "env", "readlink"):
                (tools / tool).symlink_to(shutil.which(tool) or tool)
            shutil.copy(ROOT / "evoloop", folder)
            shutil.copytree(ROOT / "scripts", folder / "scripts")
            for command in ("", "setup", "install", "test", "package", "docs", "api", "reproducible"):
                for option in ("--help", "-h"):
                    with self.subTest(command=command, option=option):
                        result = subprocess.run(
                            [folder / "evoloop", *command.split(), option],
                            env={"PATH": str(tools)},
                            capture_output=True,
                            encoding="utf-8",
                            timeout=30,
                        )
                        self.assertEqual((result.returncode, result.stderr), (0, ""))
                        self.assertRegex(result.stdout, f"(?i)^usage: .*{command}")
            self.assertEqual({file.name for file in folder.iterdir()}, {"bin", "evoloop", "scripts"})


class CommandsTest(unittest.TestCase):
    """Runs in a copy, so that nothing is written into the project; the project's build is also valid in the copy."""

    @classmethod
    def setUpClass(cls) -> None:
        folder = tempfile.TemporaryDirectory(prefix="evoloop-commands-")
        cls.addClassCleanup(folder.cleanup)
        cls.copy = Path(folder.name) / "evoloop"
        shutil.copytree(ROOT, cls.copy, symlinks=True, ignore=shutil.ignore_patterns(*NOT_COPIED))
        cls.keep_what_is_compiled()
        cls.leave_the_coverage_of_a_few_tests()
        cls.robot = cls.camera = ""
        if any(placeholder in entry.run for entry in DUE for placeholder in (ROBOT, CAMERA)):
            cls.start_robot()

    @classmethod
    def keep_what_is_compiled(cls) -> None:
        """Maven recompiles if the sources differ from its list of the last build's, which has absolute paths."""
        for sources in cls.copy.glob("**/target/maven-status/**/inputFiles.lst"):
            sources.write_text(sources.read_text(encoding="utf-8").replace(f"{ROOT}/", f"{cls.copy}/"), encoding="utf-8")

    @classmethod
    def leave_the_coverage_of_a_few_tests(cls) -> None:
        """As after ./mvnw -Dtest=..., which must not keep ./evoloop install from installing."""
        (cls.copy / "framework" / "core" / "target" / "jacoco.exec").write_bytes(b"")

    @classmethod
    def start_robot(cls) -> None:
        cls.robot = str(cls.copy / "robot")
        simulator = subprocess.Popen(
            ["./evoloop", "simulator", "--link", cls.robot, "--camera", "0", "--room", "living-room"],
            cwd=cls.copy,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        cls.addClassCleanup(cls.end, simulator)
        assert simulator.stdout
        ready = simulator.stdout.readline().split()
        camera = simulator.stdout.readline().split()
        if ready[:1] != ["ready"] or camera[:1] != ["camera"]:
            raise AssertionError(f"the simulator said {ready} and {camera}")
        cls.camera = camera[1]

    @staticmethod
    def end(simulator: subprocess.Popen[str]) -> None:
        simulator.communicate(timeout=LIMIT_S)

    def test_documented_commands_work(self) -> None:
        """Commands with and without the robot run in parallel; slow ones measure, so they run alone."""
        lanes: dict[bool, list[Known]] = {}
        for entry in DUE:
            lanes.setdefault(not SLOW and bool({ROBOT, CAMERA, "roomba"} & set(entry.run.split())), []).append(entry)
        with ThreadPoolExecutor(len(lanes)) as threads:
            for failures in threads.map(self.failures, lanes.values()):
                for entry, failure in failures:
                    with self.subTest(command=entry.documented):
                        raise failure

    def failures(self, lane: list[Known]) -> list[tuple[Known, Exception]]:
        failures: list[tuple[Known, Exception]] = []
        for entry in lane:
            try:
                self.check(entry)
            except (AssertionError, unittest.SkipTest, subprocess.TimeoutExpired) as failure:
                failures.append((entry, failure))
        return failures

    def check(self, entry: Known) -> None:
        if entry.needs_study and not (ROOT / "prism" / ".venv").exists():
            self.skipTest("network: ./evoloop study has not been set up")
        line = entry.run.replace(ROBOT, self.robot).replace(CAMERA, self.camera)
        result = subprocess.run(
            ["bash", "-c", line],
            cwd=self.copy,
            input=entry.input,
            capture_output=True,
            encoding="utf-8",
            timeout=LIMIT_S,
        )
        if entry.not_now and entry.not_now in result.stderr:
            self.skipTest(entry.not_now)
        said = f"{line}\n{result.stdout[-2000:]}\n{result.stderr[-2000:]}"
        self.assertEqual(result.returncode, 0, said)
        self.assertNotIn("\nerror: ", f"\n{result.stdout}{result.stderr}", said)
        self.assertNotIn("\n\tat ", result.stderr, said)
        self.assertIn(entry.shows, result.stdout, said)
        self.assertNotIn("evoloop: building", result.stderr, "what was built before is built again")


if __name__ == "__main__":
    unittest.main()
