"""./evoloop without a locale, as in a container."""

from __future__ import annotations

import os
import subprocess
import unittest

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


if __name__ == "__main__":
    unittest.main()
