"""Runs Spin, which writes a verifier in C that gcc compiles."""

import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from study.problem import Problem
from study.proof.plan import ACTS, CLOCKWORK, NUMBERS, Acts

SPECIFICATION = Path(__file__).resolve().parent.parent.parent / "proof"
_SIZES = ("-DPLACES=6", "-DFACTS=6", "-DMOST_ATTEMPTS=2")
_LONGEST_S = 600
_MEMORY_MB = 6000


@dataclass(frozen=True)
class Result:
    """What an exhaustive search found."""

    states: int
    depth: int
    memory_mb: float
    seconds: float
    broken: str
    """The property that was found violated; empty if none was."""
    trail: str
    """The steps up to the violation."""


def require() -> None:
    """@raises Problem if Spin or the compiler is missing."""
    missing = [tool for tool in ("spin", "gcc") if shutil.which(tool) is None]
    if missing:
        raise Problem(
            f"--proof needs {' and '.join(missing)}: ./evoloop study --proof installs it where there is apt-get; "
            "by hand: apt-get install spin gcc libc6-dev (Spin 6.5 or newer)"
        )


def search(folder: Path, tables: str, acts: Acts, definitions: tuple[str, ...], only: str = "") -> Result:
    """Checks the specification in every interleaving: all safety properties, or the named one."""
    prepare(folder, tables)
    live = only in CLOCKWORK
    defined = [*_SIZES, *(f"-D{act}={acts.get(act, 0)}" for act in ACTS), *definitions]
    if only:
        defined.append(f"-DONLY={NUMBERS.index(only) if only in NUMBERS else 99}")
    call(["spin", *defined, "-a", "proof.pml"], folder)
    kept = ["-DNFAIR=4"] if live else ["-DSAFETY", "-DNOCLAIM", "-DREACH"]
    # COLLAPSE stores complete states in compressed form, so the search does not depend on hashing.
    # A violation that is expected is found soon: optimizing would take longer than the search.
    speed = "-O0" if only and not live else "-O1"
    call(["gcc", speed, "-w", "-DCOLLAPSE", f"-DMEMLIM={_MEMORY_MB}", *kept, "-o", "pan", "pan.c"], folder)
    short = ["-i", "-m3000"] if only and not live else ["-m2000000"]
    said = call(["./pan", *(["-a", "-f", "-N", only] if live else ["-E"]), *short], folder)
    return _result(said, folder, only if live else "")


def prepare(folder: Path, tables: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.trail"):
        old.unlink()
    for source in SPECIFICATION.glob("*.pml"):
        shutil.copy(source, folder)
    (folder / "tables.pml").write_text(tables, encoding="utf-8")


def call(command: list[str], folder: Path) -> str:
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=_LONGEST_S)
    except subprocess.TimeoutExpired as late:
        raise Problem(f"{command[0]} in {folder} takes more than {_LONGEST_S} s; nothing is proved") from late
    if done.returncode != 0 or "Error:" in done.stdout:
        raise Problem(f"{' '.join(command[:1])} in {folder} failed: {(done.stdout + done.stderr).strip()[-600:]}")
    return done.stdout


def _result(said: str, folder: Path, live: str) -> Result:
    found = re.search(r"depth reached (\d+), errors: (\d+)\s+(\d+) states, stored(?: \((\d+) visited\))?", said)
    memory = re.search(r"([\d.]+)\s+total actual memory usage", said)
    if found is None or memory is None:
        raise Problem(f"the verifier in {folder} did not say what it found: {said.strip()[-600:]}")
    broken, trail = "", ""
    if int(found[2]):
        trail = "\n".join(line.strip() for line in call(["./pan", *(["-N", live] if live else []), "-r", "proof.pml.trail"], folder).splitlines())
        violated = re.search(r"^violated (\d+)$", trail, re.MULTILINE)
        broken = live or (NUMBERS[int(violated[1])] if violated else "")
        if not broken:
            raise Problem(f"the verifier in {folder} met a bound of the specification: {said.strip()[:300]}")
    elif "not completed" in said or "too small" in said or "out of memory" in said:
        raise Problem(f"the search in {folder} is not exhaustive: {said.strip()[:600]}")
    seconds = re.search(r"elapsed time ([\d.]+)", said)
    return Result(
        int(found[4] or found[3]), int(found[1]), float(memory[1]), float(seconds[1]) if seconds else 0.0, broken, trail
    )
