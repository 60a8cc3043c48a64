"""A build by ./evoloop shows its progress on terminals only, and errors everywhere; Maven is replaced by a fake here."""

from __future__ import annotations

import os
import pty
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from test_commands import ROOT

MAVEN = """#!/bin/sh
echo "[INFO] Building Evoloop core 0.1.0-SNAPSHOT                            [3/28]"
until [ -e go-on ]; do sleep 0.1; done
echo "[INFO] a word about nothing"
[ -e good ] || { echo "[ERROR] Lamp.java:[3,7] cannot find symbol"; exit 1; }
"""


class ProgressTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        shutil.copy(ROOT / "evoloop", self.root)
        shutil.copytree(ROOT / "scripts", self.root / "scripts")
        (self.root / "mvnw").write_text(MAVEN)
        (self.root / "mvnw").chmod(0o755)
        (self.root / ".mvn").mkdir()
        (self.root / "pom.xml").write_text("<module>.mvn</module>\n")

    def build(self, error: int) -> subprocess.Popen[bytes]:
        return subprocess.Popen(
            [self.root / "evoloop", "install"],
            env={**os.environ, "HOME": str(self.root), "TERM": "xterm"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=error,
        )

    def on_a_terminal(self) -> tuple[int, str]:
        terminal, error = pty.openpty()
        with self.build(error) as program:
            os.close(error)
            shown = b""
            while b"module 3 of 28, Evoloop core" not in shown:
                shown += os.read(terminal, 1000)
            (self.root / "go-on").touch()
            try:
                while more := os.read(terminal, 1000):
                    shown += more
            except OSError:  # the end of a terminal
                pass
        os.close(terminal)
        return program.returncode, shown.decode()

    def test_a_terminal_shows_the_module(self) -> None:
        (self.root / "good").touch()
        status, shown = self.on_a_terminal()
        self.assertEqual(status, 0, shown)
        self.assertTrue(shown.endswith("\r\033[K"), "the line is gone when the build is done")
        self.assertNotIn("a word about nothing", shown)

    def test_a_failure_is_shown_and_its_log_kept(self) -> None:
        status, shown = self.on_a_terminal()
        self.assertEqual(status, 1)
        self.assertIn("[ERROR] Lamp.java:[3,7] cannot find symbol", shown)
        self.assertIn("all of them in target/install.log", shown)
        self.assertIn("a word about nothing", (self.root / "target/install.log").read_text())

    def test_a_pipe_is_told_nothing_of_it(self) -> None:
        (self.root / "go-on").touch()
        (self.root / "good").touch()
        with self.build(subprocess.PIPE) as program:
            told = program.communicate()[1].decode()
        self.assertEqual(program.returncode, 0)
        self.assertRegex(told, r"\Aevoloop: putting Evoloop's artifacts into your local Maven repository.*\n\Z")


if __name__ == "__main__":
    unittest.main()
