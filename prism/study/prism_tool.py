"""PRISM itself, as a command on the PATH."""

import math
import re
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path

from study.checking import Answers, Constants, Number, combinations, model_file, property_file, varying
from study.problem import Problem

# PRISM's default of 1e-6 is too coarse for comparisons; it refuses values below about 8e-10.
_EPSILON = "1e-9"
_NAME = re.compile(r'^Model checking: "([^"]+)":')
_MODEL_CONSTANTS = re.compile(r"^Model constants:\s*(\S+)")
_PROPERTY_CONSTANTS = re.compile(r"^Property constants:\s*(\S+)")
_RESULT = re.compile(r"^Result:\s*(\S+)")


class Prism:
    """Checks with PRISM, one process for all combinations that PRISM can iterate over by itself."""

    name = "PRISM"

    def __init__(self) -> None:
        command = shutil.which("prism")
        if command is None:
            raise Problem(
                "there is no command prism on the PATH; install PRISM from prismmodelchecker.org and put its bin "
                "directory on the PATH, or use --checker storm",
                status=2,
            )
        self._command = command

    def check(self, model: str, properties: str, constants: Constants) -> Answers:
        answers = Answers()
        varied = varying(constants)
        fixed = {name: str(value) for name, value in constants.items() if name not in varied}
        ranges = {name: text for name, values in varied.items() if (text := _range(values)) is not None}
        for chosen in combinations({name: varied[name] for name in varied if name not in ranges}):
            given = fixed | ranges | {name: str(value) for name, value in chosen.items()}
            log = self._run(model_file(model), property_file(properties), given)
            for question, of_question, value in read_results(log):
                answers.put(question, {name: of_question[name] for name in varied if name in of_question}, value)
        return answers

    def _run(self, model: Path, properties: Path, constants: dict[str, str]) -> str:
        assignments = ",".join(f"{name}={value}" for name, value in constants.items())
        done = subprocess.run(
            [self._command, str(model), str(properties), "-sparse", "-epsilon", _EPSILON, "-const", assignments],
            capture_output=True,
            text=True,
            check=False,
        )
        complaint = next((line for line in done.stdout.splitlines() if line.startswith("Error:")), None)
        if done.returncode != 0 or complaint is not None:
            why = complaint or next(iter(done.stderr.split("\n")), "") or f"status {done.returncode}"
            raise Problem(f"{model} with {properties.name}: PRISM says: {why}")
        return done.stdout


def _range(values: Sequence[Number]) -> str | None:
    """PRISM's notation for equally spaced values, None for others."""
    if len(values) == 1:
        return str(values[0])
    step = round(values[1] - values[0], 9)
    spaced = all(math.isclose(value, values[0] + index * step) for index, value in enumerate(values))
    return f"{values[0]}:{step}:{values[-1]}" if spaced and step > 0 else None


def read_results(log: str) -> Iterator[tuple[str, dict[str, float], float]]:
    """Name, constants and value of each property in a log of PRISM, in order."""
    name, of_model, of_property = "", {}, {}
    for line in log.splitlines():
        if found := _MODEL_CONSTANTS.match(line):
            of_model = _assignments(found[1])
        elif found := _NAME.match(line):
            name, of_property = found[1], {}
        elif found := _PROPERTY_CONSTANTS.match(line):
            of_property = _assignments(found[1])
        elif found := _RESULT.match(line):
            yield name, {**of_model, **of_property}, float(found[1])


def _assignments(text: str) -> dict[str, float]:
    return {name: float(value) for name, _, value in (part.partition("=") for part in text.split(","))}
