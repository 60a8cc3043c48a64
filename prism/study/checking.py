"""The interface of checkers: they evaluate the properties of a file for a model, for all combinations of constants."""

import itertools
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Protocol

MODELS = Path(__file__).resolve().parent.parent / "models"

Number = float | int
Constants = Mapping[str, Number | Sequence[Number]]
"""Constants by name. One given as a sequence varies: every combination of varying constants is checked."""


class Answers:
    """The values of properties, by name and by the varying constants on which they depend."""

    def __init__(self) -> None:
        self._values: dict[tuple[str, frozenset[tuple[str, float]]], float] = {}

    def put(self, name: str, constants: Mapping[str, Number], value: float) -> None:
        self._values[name, _key(constants)] = value

    def value(self, name: str, **constants: Number) -> float:
        return self._values[name, _key(constants)]

    def largest_difference(self, other: "Answers", relative: bool) -> float:
        """
        The largest difference from the answers of another checker; infinite where one of them has no answer.

        If relative, the difference of two values above 1 counts in proportion to them.
        """
        if self._values.keys() != other._values.keys():
            return float("inf")
        differences = (_difference(value, other._values[key], relative) for key, value in self._values.items())
        return max(differences, default=0.0)


def _key(constants: Mapping[str, Number]) -> frozenset[tuple[str, float]]:
    # Checkers compute a range in steps, so that 0.3 may come back as 0.30000000000000004.
    return frozenset((name, round(float(value), 9)) for name, value in constants.items())


def _difference(one: float, other: float, relative: bool) -> float:
    if one == other:
        return 0.0
    return abs(one - other) / (max(1.0, one, other) if relative else 1.0)


def varying(constants: Constants) -> dict[str, Sequence[Number]]:
    """The constants that are given as a sequence."""
    return {name: value for name, value in constants.items() if isinstance(value, Sequence)}


def combinations(values: Mapping[str, Sequence[Number]]) -> Iterator[dict[str, Number]]:
    """Every combination of the values of these constants; one empty combination if there are none."""
    for chosen in itertools.product(*values.values()):
        yield dict(zip(values, chosen, strict=True))


class Checker(Protocol):
    """A probabilistic model checker."""

    name: str

    def check(self, model: str, properties: str, constants: Constants) -> Answers:
        """
        Checks every property of ``properties`` (the name of a .props file) for ``model`` (the name of a .sm file).

        Raises Problem if a file or a constant does not fit.
        """
        ...


def model_file(model: str) -> Path:
    return MODELS / f"{model}.sm"


def property_file(properties: str) -> Path:
    return MODELS / f"{properties}.props"
