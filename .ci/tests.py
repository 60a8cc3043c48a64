"""Runs the tests of all modules after a build, and prints a line for each, with the log of what failed.

Tests wait more than they compute, and no module's tests need those of another: several modules are tested at a time, in no
order but that the longest begin first. Each has a Maven of its own, which finds the other modules in target/repository.
Some tests have limits in real time, as serial links do, which a processor shared by so many may miss: a module that fails
is tested once more when it has the machine for itself, and counts as failed if it fails then.

The run's own files are in target: test.begun, which is as old as the run, and documented-commands.log; in that of each
module are Maven's test.log, and surefire-reports.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

TARGET = Path("target")
REPOSITORY = TARGET / "repository"
AT_A_TIME = 2 * (os.cpu_count() or 1)
LONGEST = (
    *("framework/core", "roomba-converter", "fleet", "prism/experiment", "fleet/edge", "framework/journal", "framework/xmi"),
    *("lightbulb-example", "roomba-converter/camera", "framework/models", "framework/page", "roomba-converter/simulator"),
    *("framework/mqtt", "benchmarks"),
)
TRACE_LINES = 40
"""Of a failure: enough for its message and the frames of the test."""
OUTPUT_LINES = 60
"""Of what a failed test printed, the last lines."""
ERROR_LINES = 30
UNITTEST = re.compile(r"^Ran (\d+) tests? in ([\d.]+)s$", re.MULTILINE)
POM = "{http://maven.apache.org/POM/4.0.0}"


@dataclass(frozen=True)
class Counts:
    run: int = 0
    failures: int = 0
    errors: int = 0
    skipped: int = 0

    def __add__(self, other: Counts) -> Counts:
        return Counts(
            self.run + other.run,
            self.failures + other.failures,
            self.errors + other.errors,
            self.skipped + other.skipped,
        )

    def __str__(self) -> str:
        """In the words of Maven Surefire, which other programs look for."""
        return f"Tests run: {self.run}, Failures: {self.failures}, Errors: {self.errors}, Skipped: {self.skipped}"


def reports(module: Path) -> Iterator[tuple[Path, ElementTree.Element]]:
    """The reports of a module's test classes in this run, each with its file."""
    begun = (TARGET / "test.begun").stat().st_mtime
    for file in sorted((module / "target" / "surefire-reports").glob("TEST-*.xml")):
        if file.stat().st_mtime >= begun:
            yield file, ElementTree.parse(file).getroot()


def counts(module: Path) -> Counts:
    return sum(
        (Counts(*(int(suite.get(name, 0)) for name in ("tests", "failures", "errors", "skipped"))) for _, suite in reports(module)),
        Counts(),
    )


def modules() -> list[Path]:
    return [Path(str(module.text)) for module in ElementTree.parse("pom.xml").getroot().iter(f"{POM}module")]


def offer(module: Path) -> None:
    """Puts what was built of a module, or the parent, where the Mavens of others look for it."""
    pom = ElementTree.parse(module / "pom.xml").getroot()
    name = pom.findtext(f"{POM}artifactId", "")
    version = pom.findtext(f"{POM}version") or pom.findtext(f"{POM}parent/{POM}version", "")
    folder = REPOSITORY / "org" / "evoloop" / name / version
    folder.mkdir(parents=True)
    shutil.copy(module / "pom.xml", folder / f"{name}-{version}.pom")
    for jar in (module / "target").glob(f"{name}-{version}*.jar"):
        shutil.copy(jar, folder)
    # A program's jar has a name of its own, and may contain the libraries; then the original one is beside it.
    program = pom.findtext(f"{POM}build/{POM}finalName")
    for jar in (f"{program}.jar", f"original-{program}.jar"):
        if program and (module / "target" / jar).exists():
            shutil.copy(module / "target" / jar, folder / f"{name}-{version}.jar")


def run(module: Path, options: list[str]) -> tuple[Path, bool, float]:
    """Runs a module's tests and checks; returns whether they passed, and the seconds they took."""
    begun = time.monotonic()
    with (module / "target" / "test.log").open("wb") as log:
        passed = subprocess.run(
            [
                *("./mvnw", "-B", "--no-transfer-progress", "-pl", str(module), "-Dmaven.test.redirectTestOutputToFile=true"),
                *(f"-Dmaven.repo.local={REPOSITORY.absolute()}", f"-Dmaven.repo.local.tail={Path.home() / '.m2' / 'repository'}"),
                # Several Mavens may fetch the same files.
                *("-Daether.syncContext.named.factory=file-lock", "-Daether.syncContext.named.nameMapper=file-gav"),
                # What is built is not compiled again for being taken from elsewhere.
                *("-Dmaven.compiler.useIncrementalCompilation=false", *options, "verify"),
            ],
            stdin=subprocess.DEVNULL,
            stdout=log,
            stderr=subprocess.STDOUT,
        )
    return module, passed.returncode == 0, time.monotonic() - begun


def counted(tests: int) -> str:
    return "1 test" if tests == 1 else f"{tests} tests" if tests else ""


def line(name: str, tests: int, took: float, failed: bool) -> str:
    return f"{name:<34}{counted(tests):>12}{took:>7.0f} s{'  FAILED' if failed else ''}"


def last(text: str, most: int) -> str:
    lines = text.rstrip().splitlines()
    left_out = [f"[{len(lines) - most} earlier lines]"] if len(lines) > most else []
    return "\n".join([*left_out, *lines[-most:]])


def failures(module: Path) -> Iterator[str]:
    """The failed tests of a module, each with its trace, and the end of what its class printed."""
    for file, suite in reports(module):
        failed = [(case, fault) for case in suite.iter("testcase") for tag in ("failure", "error") for fault in case.findall(tag)]
        for case, fault in failed:
            trace = (fault.text or fault.get("message", "")).strip().splitlines()
            yield "\n".join([f"-- {module}: {case.get('classname')}.{case.get('name')}", *trace[:TRACE_LINES]])
        printed = file.with_name(f"{file.stem.removeprefix('TEST-')}-output.txt")
        if failed and printed.exists():
            yield f"-- the end of {printed}\n{last(printed.read_text(encoding='utf-8', errors='replace'), OUTPUT_LINES)}"


def show(module: Path, passed: bool, took: float) -> None:
    print(line(str(module), counts(module).run, took, not passed))
    failed = list(failures(module))
    print(*failed, sep="\n", end="\n" if failed else "")
    if not passed and not failed:
        # No test explains it: that the module can't be checked, or too little of it is covered.
        log = (module / "target" / "test.log").read_text(encoding="utf-8", errors="replace")
        errors = [each for each in log.splitlines() if each.startswith("[ERROR]")]
        print("\n".join(errors[:ERROR_LINES]) or last(log, ERROR_LINES))
    sys.stdout.flush()


def run_modules(options: list[str]) -> int:
    shutil.rmtree(REPOSITORY, ignore_errors=True)
    for module in (Path(), *modules()):
        offer(module)
    tested = [module for module in modules() if (module / "src" / "test").exists()]
    tested.sort(key=lambda module: LONGEST.index(str(module)) if str(module) in LONGEST else len(LONGEST))
    begun = time.monotonic()
    with ThreadPoolExecutor(AT_A_TIME) as lanes:
        runs = [lanes.submit(run, module, options) for module in tested]
        left = set(runs)
        try:
            while left:
                done, left = wait(left, timeout=1, return_when=FIRST_COMPLETED)
                for each in done:
                    show_progress("")
                    show(*each.result())
                show_progress(f"evoloop: {time.monotonic() - begun:.0f} s: {len(runs) - len(left)} of {len(runs)} modules tested")
        except KeyboardInterrupt:
            lanes.shutdown(cancel_futures=True)
            raise SystemExit(130) from None
    show_progress("")
    failed = [module for module, passed, _ in (each.result() for each in runs) if not passed]
    return 0 if all([passes_alone(module, options) for module in failed]) else 1


def passes_alone(module: Path, options: list[str]) -> bool:
    print(f"{module}: once more, alone", flush=True)
    _, passed, took = run(module, options)
    show(module, passed, took)
    return passed


def show_progress(text: str) -> None:
    """One line on a terminal, instead of the last; nothing elsewhere."""
    if sys.stderr.isatty():
        print(f"\r\033[K{text}", end="", file=sys.stderr, flush=True)


def commands() -> tuple[Counts, float, str]:
    """The tests of the documented commands in this run, the seconds they took, and their log from the first failure on."""
    log = TARGET / "documented-commands.log"
    if not log.exists() or log.stat().st_mtime < (TARGET / "test.begun").stat().st_mtime:
        return Counts(), 0, ""
    text = log.read_text(encoding="utf-8", errors="replace")
    ran = UNITTEST.search(text)
    if not ran:
        return Counts(), 0, last(text, OUTPUT_LINES)
    said = {name: int(number) for name, number in re.findall(r"(failures|errors|skipped)=(\d+)", text[ran.end() :])}
    return Counts(int(ran[1]), **said), float(ran[2]), text[text.find("=" * 70) : ran.start()] if "FAILED" in text[ran.end() :] else ""


def show_commands() -> None:
    found, took, failed = commands()
    print(line("documented commands", found.run, took, bool(failed)))
    if failed:
        print(failed)


def show_total() -> None:
    print(sum((counts(module) for module in modules()), commands()[0]))


if __name__ == "__main__":
    if sys.argv[1] == "run":
        sys.exit(run_modules(sys.argv[2:]))
    {"commands": show_commands, "total": show_total}[sys.argv[1]]()
