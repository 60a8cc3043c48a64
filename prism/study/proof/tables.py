"""The decision tables of models, as the Java program compiles them from the model files."""

import shutil
import subprocess
from pathlib import Path

from study.problem import Problem
from study.proof.plan import Pair

ROOT = Path(__file__).resolve().parent.parent.parent.parent
_JAR = ROOT / "prism" / "experiment" / "target" / "study-experiment.jar"


def of(pair: Pair) -> str:
    """The decision tables of `pair`, in Promela."""
    return java(pair)


def java(pair: Pair, *options: str) -> str:
    """What the Java program prints about `pair`."""
    if not _JAR.is_file():
        raise Problem(f"{_JAR} is missing; run the proof as ./evoloop study --proof, which builds it")
    program = shutil.which("java")
    if program is None:
        raise Problem("there is no java on the PATH; ./evoloop setup installs it")
    command = [program, "-cp", str(_JAR), "org.evoloop.study.proof.Main", *pair.arguments, *options]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Problem(f"the tables of the {pair.name} cannot be made: {done.stderr.strip()}", done.returncode)
    return done.stdout


def is_built() -> bool:
    return _JAR.is_file()
