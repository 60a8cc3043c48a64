"""The scripts: ./evoloop without a locale, as in a container; and how the package's scripts read options files."""

from __future__ import annotations

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from test_commands import LIMIT_S, ROOT


class LocaleTest(unittest.TestCase):
    def test_names_are_read_and_printed_as_they_are(self) -> None:
        environment = {name: value for name, value in os.environ.items() if name != "LANG" and not name.startswith("LC_")}
        result = subprocess.run(
            [ROOT / "evoloop", "lightbulb", "--journal", "/tmp/café", "--print-config"],
            env=environment,
            capture_output=True,
            encoding="utf-8",
            timeout=LIMIT_S,
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("/tmp/café", result.stdout)


class FreshTest(unittest.TestCase):
    def test_another_release_is_refused_at_once(self) -> None:
        result = subprocess.run(
            [ROOT / "evoloop", "test", "--fresh", "trixie", "sid"], capture_output=True, encoding="utf-8", timeout=LIMIT_S
        )
        said = "evoloop: test --fresh: 'sid' is neither bookworm nor trixie\n"
        self.assertEqual((result.returncode, result.stdout, result.stderr), (2, "", said))


class OptionsFileTest(unittest.TestCase):
    COMMON = ROOT / "framework/package/root/usr/lib/evoloop/common"

    def value_of(self, key: str, text: bytes) -> str:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "robot.yaml")
            file.write_bytes(text)
            result = subprocess.run(
                ["sh", "-euc", '. "$1"; value_of "$2" "$3"', "sh", self.COMMON, key, file],
                capture_output=True,
                encoding="utf-8",
                check=True,
                timeout=LIMIT_S,
            )
        return result.stdout.rstrip("\n")

    def test_a_value_is_found_however_its_line_is_written(self) -> None:
        for line in (
            b"port: /dev/robot",
            b"port : '/dev/robot' # at the back",
            b'"port":\t"/dev/robot"\r',
            b"'port':   /dev/robot  ",
            b"\xef\xbb\xbfport: /dev/robot",
            b"program: roomba\nport: /dev/robot\nport: /dev/other",
        ):
            with self.subTest(line):
                self.assertEqual(self.value_of("port", line + b"\n"), "/dev/robot")

    def test_other_lines_are_not_its_value(self) -> None:
        for line in (b"port:", b"port: # none", b"export: /dev/robot", b"  port: /dev/robot", b"port:/dev/robot", b"# port: x"):
            with self.subTest(line):
                self.assertEqual(self.value_of("port", line + b"\n"), "")


if __name__ == "__main__":
    unittest.main()
