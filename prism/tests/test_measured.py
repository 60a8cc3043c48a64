"""Benchmark results as they are and as they should not be."""

import json
import tempfile
import unittest
from pathlib import Path

from study import measured
from study.problem import Problem


class MeasuredTest(unittest.TestCase):
    def test_reads_the_mean_of_the_event_path(self) -> None:
        self.assertAlmostEqual(self._read(self._result(32.5, "us/op")).conversion_s, 32.5e-6)

    def test_refuses_what_is_no_time(self) -> None:
        for score, unit in ((32.5, "ops/s"), ("NaN", "us/op"), (0, "us/op")):
            with self.subTest(score=score, unit=unit), self.assertRaisesRegex(Problem, "not a time"):
                self._read(self._result(score, unit))

    def test_names_the_benchmark_that_is_missing(self) -> None:
        for results in ([], {}, [{"benchmark": "other"}]):
            with self.subTest(results=results), self.assertRaisesRegex(Problem, measured.BENCHMARK):
                self._read(results)

    def test_names_the_file_that_cannot_be_read(self) -> None:
        with self.assertRaisesRegex(Problem, "no-such-file.json cannot be read"):
            measured.read(Path("no-such-file.json"))

    @staticmethod
    def _result(score: object, unit: str) -> list[dict[str, object]]:
        metric = {"score": score, "scoreUnit": unit}
        benchmark = f"org.evoloop.benchmarks.{measured.BENCHMARK}"
        return [{"benchmark": benchmark, "secondaryMetrics": {"gc.alloc.rate": {}, measured.METRIC: metric}}]

    @staticmethod
    def _read(results: object) -> measured.Measured:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "results.json"
            path.write_text(json.dumps(results))
            return measured.read(path)
