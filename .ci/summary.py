"""What ./evoloop test prints of a run: a line for each module, the log of what failed, and one line for the whole run.

The run's own files are in target: test.begun, which is as old as the run, Maven's test.log, and documented-commands.log.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

TARGET = Path("target")
TRACE_LINES = 40
"""Of a failure: enough for its message and the frames of the test."""
OUTPUT_LINES = 60
"""Of what a failed test printed, the last lines."""
ERROR_LINES = 30
MODULE = re.compile(r"\[INFO\] (\S.*?) \.+ (SUCCESS|FAILURE|SKIPPED)(?: \[ *([\d:.]+) (?:s|min|h)\])?$")
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


def modules() -> dict[str, Path]:
    """The directory of each module, by its name."""
    root = ElementTree.parse("pom.xml").getroot()
    found = [Path(), *(Path(str(module.text)) for module in root.iter(f"{POM}module"))]
    return {ElementTree.parse(module / "pom.xml").getroot().findtext(f"{POM}name", str(module)): module for module in found}


def seconds(duration: str | None) -> str:
    """Maven writes 5.895, 01:16 (minutes) or 01:02 (hours), of which no run has any."""
    total = 0.0
    for part in (duration or "0").split(":"):
        total = 60 * total + float(part)
    return f"{total:.0f} s"


def counted(tests: int) -> str:
    return "1 test" if tests == 1 else f"{tests} tests" if tests else ""


def line(name: str, tests: int, took: str, remark: str) -> str:
    return f"{name:<34}{counted(tests):>12}{took:>9}{remark}".rstrip()


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


def show_modules() -> None:
    log = (TARGET / "test.log").read_text(encoding="utf-8", errors="replace")
    directories, unexplained = modules(), True
    for name, result, took in (found.groups() for found in map(MODULE.match, log.splitlines()) if found):
        module = directories[name]
        remark = {"SUCCESS": "", "FAILURE": "  FAILED", "SKIPPED": "  not run, since another failed"}[result]
        print(line("parent" if module == Path() else str(module), counts(module).run, seconds(took), remark))
        for failure in failures(module):
            unexplained = False
            print(failure)
    if "BUILD SUCCESS" not in log and unexplained:
        errors = [each for each in log.splitlines() if each.startswith("[ERROR]")]
        print("\n".join(errors[:ERROR_LINES]) or last(log, ERROR_LINES))


def commands() -> tuple[Counts, str, str]:
    """The tests of the documented commands in this run, the seconds they took, and their log from the first failure on."""
    log = TARGET / "documented-commands.log"
    if not log.exists() or log.stat().st_mtime < (TARGET / "test.begun").stat().st_mtime:
        return Counts(), "0", ""
    text = log.read_text(encoding="utf-8", errors="replace")
    ran = UNITTEST.search(text)
    if not ran:
        return Counts(), "0", last(text, OUTPUT_LINES)
    said = {name: int(number) for name, number in re.findall(r"(failures|errors|skipped)=(\d+)", text[ran.end() :])}
    return Counts(int(ran[1]), **said), ran[2], text[text.find("=" * 70) : ran.start()] if "FAILED" in text[ran.end() :] else ""


def show_commands() -> None:
    found, took, failed = commands()
    print(line("documented commands", found.run, seconds(took), "  FAILED" if failed else ""))
    if failed:
        print(failed)


def show_total() -> None:
    print(sum((counts(module) for module in modules().values()), commands()[0]))


if __name__ == "__main__":
    {"modules": show_modules, "commands": show_commands, "total": show_total}[sys.argv[1]]()
