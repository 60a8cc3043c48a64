"""The command line."""

import argparse
import sys
from pathlib import Path

from study import closed_forms, curves
from study.both import Both
from study.checking import Checker
from study.prism_tool import Prism
from study.problem import Problem
from study.storm import Storm

RESULTS = Path(__file__).resolve().parent.parent / "results"
_AGREEMENT = 1e-6


def main(arguments: list[str]) -> int:
    options = _parse(arguments)
    try:
        checker = _checker(options.checker)
        if options.check:
            return _check(checker)
        return _study(checker)
    except Problem as problem:
        say(str(problem))
        return problem.status
    except KeyboardInterrupt:
        return 130


def say(text: str) -> None:
    """Tells the user what goes on; results go to stdout."""
    print(f"study: {text}", file=sys.stderr, flush=True)


def _parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="./evoloop study",
        description="Checks the models of prism/models and writes tables, plots and a report to prism/results.",
    )
    parser.add_argument("--check", action="store_true", help="only compare with the closed forms that are known")
    parser.add_argument(
        "--checker", choices=("storm", "prism", "both"), default="storm", help="what checks the models (default: storm)"
    )
    return parser.parse_args(arguments)


def _checker(name: str) -> Checker:
    if name == "both":
        return Both(Storm(), Prism())
    return Prism() if name == "prism" else Storm()


def _check(checker: Checker) -> int:
    found = closed_forms.checks(checker)
    for check in found:
        print(check)
    return 0 if all(check.holds() for check in found) and _agree(checker) else 1


def _study(checker: Checker) -> int:
    RESULTS.mkdir(exist_ok=True)
    say(f"checking the paper's properties with {checker.name}")
    computed = curves.compute(checker)
    curves.curves_table(computed).write(RESULTS)
    curves.summary_table(computed).write(RESULTS)
    return 0 if _agree(checker) else 1


def _agree(checker: Checker) -> bool:
    if not isinstance(checker, Both):
        return True
    print(f"largest difference between {checker.name}: {checker.largest_difference:.2e}")
    return checker.largest_difference < _AGREEMENT
