"""The command line's messages about wrong usage."""

import contextlib
import io
import unittest

from study.cli import main


class CliTest(unittest.TestCase):
    def test_slow_goes_with_check(self) -> None:
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors), self.assertRaises(SystemExit) as ended:
            main(["--slow"])
        self.assertEqual(ended.exception.code, 2)
        self.assertIn("--slow goes with --check", errors.getvalue())

    def test_a_proof_is_no_check(self) -> None:
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors), self.assertRaises(SystemExit) as ended:
            main(["--proof", "--check"])
        self.assertEqual(ended.exception.code, 2)
        self.assertIn("--proof does not go with --check", errors.getvalue())

    def test_names_the_results_that_are_not_there(self) -> None:
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.assertEqual(main(["--measured", "no-such-file.json"]), 2)
        self.assertRegex(errors.getvalue(), "^study: --measured: no-such-file.json cannot be read .*bench --json FILE")
