"""Small changes to a model or properties file, one at a time, like typing errors."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

_COMMENT = re.compile(r"//.*")
_COMMAND = re.compile(r"\[(?P<label>\w*)](?P<guard>[^;]*?)->(?:(?P<rate>[^;:()']*):)?(?P<update>[^;]*);")
_REWARD = re.compile(r"^ +(?:\[\w+] +)?[^;:>]+ : (?!bool|\[)[^;>]+;$", re.MULTILINE)
_REWARD_NAME = re.compile(r'(?<=R\{")\w+')
_NUMBER = re.compile(r"(?<![\w.'])(?:\d+\.\d+|\d+)(?![\w.])")
# A rate or a reward, which need not be an integer.
_MEASURE = re.compile(r"(?:const double \w+ = | : )([\d.]+)[/;]")

# A text and its replacement.
_WORDS = (
    (re.compile(r"\btrue\b"), "false"),
    (re.compile(r"\bfalse\b"), "true"),
    (re.compile(r"\bmin\("), "max("),
    (re.compile(r"!(?=[a-z])"), ""),
    (re.compile(r"\bF(?=[ <\[])"), "G"),
    (re.compile(r"<="), "<"),
    (re.compile(r"<(?!=)"), "<="),
    (re.compile(r"(?<![-])>(?!=)"), ">="),
    (re.compile(r"!="), "="),
    (re.compile(r"(?<=\w)=(?=\w)"), "!="),
    (re.compile(r"(?<=\w)\+(?=\w)"), "-"),
    (re.compile(r"(?<=\w)-(?=\w)"), "+"),
    (re.compile(r"(?<=\d)/(?=\w)|(?<=\w)/(?=\w)"), "*"),
    (re.compile(r" & "), " | "),
    (re.compile(r" \| "), " & "),
)


@dataclass(frozen=True)
class Mutant:
    """A file with one change: its line, the original text, and the replacement."""

    text: str
    line: int
    context: str
    old: str
    new: str

    def __str__(self) -> str:
        return f"line {self.line}: '{self.old}' became '{self.new}' in: {self.context}"


def mutants(text: str) -> Iterator[Mutant]:
    """All mutants of a text; comments are left unchanged, and some mutants are equivalent to the original."""
    bare = _COMMENT.sub(lambda comment: " " * len(comment[0]), text)
    seen = {_squeezed(text)}
    for start, end, new in _changes(bare):
        mutated = text[:start] + new + text[end:]
        if _squeezed(mutated) not in seen:
            seen.add(_squeezed(mutated))
            line = text.count("\n", 0, start)
            yield Mutant(mutated, line + 1, text.splitlines()[line].strip(), bare[start:end], new)


def _squeezed(text: str) -> str:
    return "".join(text.split())


def _changes(bare: str) -> Iterator[tuple[int, int, str]]:
    for command in _COMMAND.finditer(bare):
        yield from _of_command(bare, command)
    for reward in _REWARD.finditer(bare):
        yield reward.start(), reward.end(), ""
    for name in _REWARD_NAME.finditer(bare):
        yield name.start(), name.end(), "taken" if name[0] == "time" else "time"
    for pattern, new in _WORDS:
        for found in pattern.finditer(bare):
            yield found.start(), found.end(), new
    for number in _NUMBER.finditer(bare):
        for new in _numbers(number[0]):
            yield number.start(), number.end(), new
    for number in _MEASURE.finditer(bare):
        yield number.start(1), number.end(1), f"{1.1 * float(number[1]):.6g}"


def _numbers(number: str) -> tuple[str, ...]:
    return () if "." in number else (str(int(number) + 1), str(int(number) - 1))


def _of_command(bare: str, command: re.Match[str]) -> Iterator[tuple[int, int, str]]:
    yield command.start(), command.end(), ""
    if command["label"]:
        yield *command.span("label"), f"{command['label']}_else"
    if command["rate"]:
        rate = command["rate"].strip()
        yield *command.span("rate"), f" 1.1*({rate}) "
    yield from _without_each_part(bare, command.span("guard"), "true")
    yield from _without_each_part(bare, command.span("update"), "true")


def _without_each_part(bare: str, span: tuple[int, int], empty: str) -> Iterator[tuple[int, int, str]]:
    """A guard without one of its conditions, or an update without one of its assignments."""
    parts = bare[span[0] : span[1]].split(" & ")
    for index in range(len(parts)):
        left = " & ".join(part.strip() for other, part in enumerate(parts) if other != index)
        yield *span, f" {left or empty} "
