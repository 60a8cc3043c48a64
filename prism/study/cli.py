"""The command line."""

import argparse
import sys
import unittest
from pathlib import Path

from study import closed_forms, pinned
from study.both import Both
from study.checking import Checker
from study.comparing import failures
from study.measured import Measured, newest, read
from study.prism_tool import Prism
from study.problem import Problem
from study.storm import Storm

_ROOT = Path(__file__).resolve().parent.parent.parent
_AGREEMENT = 1e-6


def main(arguments: list[str]) -> int:
    options = _parse(arguments)
    try:
        return _check(options) if options.check else _study(options)
    except Problem as problem:
        say(str(problem))
        return problem.status
    except KeyboardInterrupt:
        return 130


def say(text: str) -> None:
    """Reports progress to the user; results go to stdout."""
    print(f"study: {text}", file=sys.stderr, flush=True)


def _parse(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="./evoloop study",
        description="Checks the models of prism/models and writes tables, plots and a report to prism/results.",
        epilog="Exit status: 0 success, 1 a check failed or something could not be done, 2 wrong usage or input.",
    )
    parser.add_argument(
        "--check",
        action="store_true",
        help="only run the study's own tests, and compare with known closed forms and the values of models/pinned.csv",
    )
    parser.add_argument(
        "--slow",
        action="store_true",
        help="with --check: run the slow tests instead, which make mutants of every model file "
        "and fail if one is not detected",
    )
    parser.add_argument(
        "--checker",
        choices=("storm", "prism", "both"),
        default="storm",
        help="the model checker: Storm (default), PRISM if it is on the PATH, or both, with their largest difference",
    )
    parser.add_argument(
        "--experiment", action="store_true", help="also measure the running converter, and compare it with the models"
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="N", help="the seed of the experiment's first point (default: 1)"
    )
    parser.add_argument(
        "--proof",
        action="store_true",
        help="also check the specification of the converter in prism/proof in every interleaving, with Spin; "
        "takes several minutes",
    )
    parser.add_argument(
        "--measured",
        nargs="?",
        const="",
        metavar="FILE",
        help="use the conversion times in FILE, written by ./evoloop bench --json FILE; "
        "without FILE, those of the newest file in benchmarks/results",
    )
    options = parser.parse_args(arguments)
    if options.slow and not options.check:
        parser.error("--slow goes with --check")
    if options.proof and options.check:
        parser.error("--proof does not go with --check")
    return options


def _checker(name: str) -> Checker:
    if name == "both":
        return Both(Storm(), Prism())
    return Prism() if name == "prism" else Storm()


def _check(options: argparse.Namespace) -> int:
    checker = _checker(options.checker)
    tests = unittest.defaultTestLoader.discover(
        str(_ROOT / "prism" / "tests"),
        pattern="slow*.py" if options.slow else "test*.py",
        top_level_dir=str(_ROOT / "prism"),
    )
    passed = unittest.TextTestRunner(verbosity=0).run(tests).wasSuccessful()
    found = closed_forms.checks(checker)
    for check in found:
        print(check)
    values = list(pinned.check(checker, pinned.pins()))
    print("\n".join(pinned.report(values)))
    return 0 if all(one.holds() for one in (*found, *values)) and passed and _agree(checker) else 1


def _study(options: argparse.Namespace) -> int:
    # Imported only here: the drawing library loads slowly, and --check does not need it.
    from study import run

    broken = run.prove(say) if options.proof else []
    for one in broken:
        say(one)
    measured = _measured(options.measured)
    checker = _checker(options.checker)
    if options.experiment:
        run.run_experiment(options.seed, say)
    if measured:
        run.take_measured(checker, measured, say)
    comparisons = run.study(checker, say)
    failed = failures(comparisons) if options.experiment else []
    for one in comparisons if options.experiment else []:
        if not one.holds():
            say(f"{one}" + ("" if one in failed else "; this is within chance"))
    print(run.RESULTS / "report.md")
    return 0 if _agree(checker) and not failed and not broken else 1


def _measured(given: str | None) -> list[Measured]:
    if given is None:
        return []
    return read(Path(given) if given else newest())


def _agree(checker: Checker) -> bool:
    if not isinstance(checker, Both):
        return True
    print(f"largest difference between {checker.name}: {checker.largest_difference:.2e}")
    return checker.largest_difference < _AGREEMENT
