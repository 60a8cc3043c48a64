"""Conformance: on random inputs and in recorded runs, the specification does what the real core does."""

import shutil
from pathlib import Path

from study.problem import Problem
from study.proof import spin, story, tables
from study.proof.plan import Pair
from study.proof.sequence import Names

_SIZES = ("-DPLACES=40", "-DFACTS=40", "-DMOST_ATTEMPTS=8")


def compare(folder: Path, pair: Pair, traces: int, seed: int, length: int = 90) -> tuple[int, str]:
    """How many inputs were compared; and the first difference, empty if there is none."""
    told = tables.java(pair, "--traces", str(traces), "--seed", str(seed), "--length", str(length))
    return accepted(folder, tables.of(pair), told)


def compare_runs(folder: Path, pair: Pair, runs: int, seed: int, acts: int = 120) -> tuple[int, str]:
    """The same for runs of the whole converter with threads, as recorded in their journals."""
    shutil.rmtree(folder / "runs", ignore_errors=True)
    options = ("--record", str(folder / "runs"), "--traces", str(runs), "--seed", str(seed), "--length", str(acts))
    return accepted(folder, tables.of(pair), tables.java(pair, *options))


def accepted(folder: Path, promela: str, told: str) -> tuple[int, str]:
    """The same for a given trace: lines with inputs, each followed by what the core then knew."""
    inputs = [line[2:] for line in told.splitlines() if line.startswith("> ")]
    core = [line for line in told.splitlines() if line.startswith("= ")]
    return _compared(inputs, core, _simulate(folder, promela, inputs))


def follows(folder: Path, promela: str, told: str) -> tuple[int, str]:
    """The same for stories in words."""
    names = Names.of(promela)
    lines = told.splitlines()
    specified = _simulate(folder, promela, [story.read(line, names) for line in lines if not line.startswith("=")])
    return _compared(
        [line for line in lines if not line.startswith("=")],
        [line for line in lines if line.startswith("=")],
        [story.state(line[2:], names) for line in specified],
    )


def _compared(inputs: list[str], core: list[str], specified: list[str]) -> tuple[int, str]:
    if len(core) != len(inputs) or len(specified) != len(inputs):
        raise Problem(f"{len(inputs)} inputs, but {len(core)} states of the core and {len(specified)} of the specification")
    for place, (one, other) in enumerate(zip(core, specified, strict=True)):
        if one != other:
            begin = max(index for index in range(place + 1) if inputs[index].lower().startswith("anew"))
            told = "\n".join(inputs[begin : place + 1])
            return place, f"{told}\nthe core:          {one}\nthe specification: {other}"
    return len(inputs), ""


def _simulate(folder: Path, promela: str, inputs: list[str]) -> list[str]:
    spin.prepare(folder, promela)
    script = folder / "script.pml"
    sends = "".join(f"  told!{','.join(line.split())};\n" for line in inputs)
    script.write_text(f"{script.read_text(encoding='utf-8')}\nproctype Script() {{\n{sends}  skip\n}}\n", encoding="utf-8")
    said = spin.call(["spin", "-T", *_SIZES, "script.pml"], folder)
    return [line.strip() for line in said.splitlines() if line.startswith("=")]
