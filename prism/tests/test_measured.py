"""Benchmark results, valid and invalid."""

import json
import tempfile
import unittest
from pathlib import Path

from study import measured
from study.problem import Problem

_CONVERSION, _BUTTON = measured.ROWS
_SUITES = Path(measured.KEPT).parent / "src" / "main" / "java" / "org" / "evoloop" / "benchmarks"


class MeasuredTest(unittest.TestCase):
    def test_reads_every_file_that_is_kept(self) -> None:
        kept = sorted(measured.KEPT.glob("*.json"))
        self.assertTrue(kept)
        for path in kept:
            with self.subTest(path.name):
                times = {one.row: one.conversion_s for one in measured.read(path)}
                self.assertEqual(set(times), set(measured.ROWS))
                rows = {row["what"]: row for row in json.loads(path.read_text())["rows"]}
                for row, time_s in times.items():
                    self.assertEqual(rows[row]["unit"], "us")
                    self.assertAlmostEqual(time_s, rows[row]["ours"] / 1e6)

    def test_finds_the_99th_percentile_where_it_stands(self) -> None:
        results = self._kept()
        rows = {row["what"]: row for row in results["rows"]}
        found = {one.row: one.percentile_s for one in self._read(results)}
        self.assertAlmostEqual(found[_CONVERSION], rows[_CONVERSION]["peers"]["p99"] / 1e6)
        self.assertAlmostEqual(found[_BUTTON], rows[measured.PERCENTILES[0]]["ours"] / 1e6)
        results["rows"] = [{**rows[_CONVERSION], "peers": {}}, rows[_BUTTON]]
        self.assertEqual([one.percentile_s for one in self._read(results)], [None, None])

    def test_benchmarks_still_write_these_rows(self) -> None:
        sources = "".join(path.read_text() for path in _SUITES.rglob("*.java"))
        for row in (*measured.ROWS, measured.PERCENTILES[0]):
            self.assertIn(f'"{row}"', sources)

    def test_takes_the_newest_of_those_that_are_kept(self) -> None:
        days = {json.loads(path.read_text())["day"] for path in measured.KEPT.glob("*.json")}
        self.assertEqual(json.loads(measured.newest().read_text())["day"], max(days))
        with tempfile.TemporaryDirectory() as folder:
            for name, day in (("z", "2026-01-02"), ("a", "2026-11-30"), ("a-again", "2026-11-30")):
                (Path(folder) / f"{name}.json").write_text(json.dumps({"day": day, "rows": []}))
            self.assertEqual(measured.newest(Path(folder)).name, "a.json")

    def test_says_so_where_nothing_is_kept(self) -> None:
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(Problem, "no results in .*bench --json"):
            measured.newest(Path(folder))

    def test_does_with_one_of_the_rows(self) -> None:
        results = self._kept()
        results["rows"] = [row for row in results["rows"] if row["what"] == _BUTTON]
        self.assertEqual([one.row for one in self._read(results)], [_BUTTON])

    def test_refuses_what_is_no_time(self) -> None:
        for value, unit in ((32.5, "events/s"), ("NaN", "us"), (float("nan"), "us"), (0, "us"), (float("inf"), "us")):
            results = self._kept()
            row = next(row for row in results["rows"] if row["what"] == _CONVERSION)
            row["ours"], row["unit"] = value, unit
            with self.subTest(value=value, unit=unit), self.assertRaisesRegex(Problem, f"{_CONVERSION}', not a time"):
                self._read(results)

    def test_names_the_rows_that_are_missing(self) -> None:
        without = self._kept()
        without["rows"] = [row for row in without["rows"] if row["what"] not in measured.ROWS]
        for results in (without, {}, [], {"rows": None}, {"rows": ["x"]}):
            with self.subTest(results=results), self.assertRaisesRegex(Problem, _CONVERSION) as raised:
                self._read(results)
            self.assertEqual(raised.exception.status, 2)

    def test_names_the_file_that_cannot_be_read(self) -> None:
        with self.assertRaisesRegex(Problem, "no-such-file.json cannot be read"):
            measured.read(Path("no-such-file.json"))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "results.json"
            path.write_text("{")
            with self.assertRaisesRegex(Problem, "results.json is not JSON"):
                measured.read(path)

    @staticmethod
    def _kept() -> dict[str, list[dict[str, object]]]:
        return json.loads(measured.newest().read_text())

    @staticmethod
    def _read(results: object) -> list[measured.Measured]:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "results.json"
            path.write_text(json.dumps(results))
            return measured.read(path)
