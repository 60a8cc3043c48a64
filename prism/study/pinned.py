"""Values that the models must have (models/pinned.csv), so that a change to a model is noticed."""

import csv
from collections.abc import Iterator
from dataclasses import dataclass

from study import checking
from study.checking import Answers, Checker, Number

_ABSOLUTE = 1e-6
_RELATIVE = 1e-5


@dataclass(frozen=True)
class Pin:
    """A value of one property for one set of constants, with its source."""

    model: str
    properties: str
    constants: tuple[tuple[str, Number], ...]
    property: str
    value: float
    source: str

    def holds(self, value: float) -> bool:
        return value == self.value or abs(value - self.value) <= _ABSOLUTE + _RELATIVE * self.value

    def __str__(self) -> str:
        given = ", ".join(f"{name}={value:g}" for name, value in self.constants)
        return f"{self.model}.sm with {self.properties}.props, {given}: {self.property}"


@dataclass(frozen=True)
class Found:
    """A pinned value beside the one that a checker has computed."""

    pin: Pin
    value: float

    def holds(self) -> bool:
        return self.pin.holds(self.value)

    def __str__(self) -> str:
        word = "ok  " if self.holds() else "FAIL"
        return f"{word} {self.pin}: {self.value:.8g}, pinned {self.pin.value:.8g} ({self.pin.source})"


def pins(model: str | None = None) -> list[Pin]:
    """The pins of one model or properties file, or all."""
    with (checking.MODELS / "pinned.csv").open(encoding="utf-8", newline="") as file:
        rows = [_pin(row) for row in csv.DictReader(file)]
    return [pin for pin in rows if model in (None, pin.model, pin.properties)]


def _pin(row: dict[str, str]) -> Pin:
    assignments = (assignment.partition("=") for assignment in row["constants"].split())
    # PRISM does not accept 2.0 as an integer.
    constants = tuple((name, int(value) if value.isdigit() else float(value)) for name, _, value in assignments)
    return Pin(row["model"], row["properties"], constants, row["property"], float(row["value"]), row["source"])


def check(checker: Checker, wanted: list[Pin]) -> Iterator[Found]:
    """Each pin with its present value; pins that one query answers must be consecutive."""
    asked: tuple[str, str, tuple[tuple[str, Number], ...]] | None = None
    answers = Answers()
    for pin in wanted:
        if asked != (pin.model, pin.properties, pin.constants):
            asked = (pin.model, pin.properties, pin.constants)
            answers = checker.check(pin.model, pin.properties, dict(pin.constants))
        yield Found(pin, answers.value(pin.property))


def report(found: list[Found]) -> list[str]:
    """A line for each model whose values are all right, and one for each wrong value."""
    lines = []
    for model in dict.fromkeys(one.pin.model for one in found):
        of_model = [one for one in found if one.pin.model == model]
        wrong = [str(one) for one in of_model if not one.holds()]
        lines += wrong or [f"ok   {model}.sm: {len(of_model)} pinned values"]
    return lines
