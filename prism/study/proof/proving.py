"""The whole proof: searches, mutants, the paper's mechanism, conformance."""

import os
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from study.proof import plan, script, sequence, spin, story, tables
from study.proof.plan import Pair
from study.proof.spin import Result
from study.tables import Table

Progress = Callable[[str], None]
_Compare = Callable[[Path, Pair, int, int], tuple[int, str]]
_TRACES = 300
_RUNS = 30


@dataclass(frozen=True)
class _Task:
    label: str
    run: Callable[[], None]


def prove(results: Path, progress: Progress) -> list[str]:
    """Writes proof*.csv and the trails' diagrams to `results`; returns the failures."""
    spin.require()
    progress("the design, proved: tables from the model files")
    promela = {pair.key: tables.of(pair) for pair in plan.PAIRS}
    proof = _Proof(promela, results)
    tasks = [*proof.searches(), *proof.mutants(), *proof.papers(), *proof.conformance()]
    progress(f"Spin: {len(tasks)} checks")
    pool = ThreadPoolExecutor(os.cpu_count() or 1)
    try:
        for done, _ in enumerate(pool.map(lambda task: task.run(), tasks), start=1):
            _progress(f"{done} of {len(tasks)}: {tasks[done - 1].label}")
    finally:
        pool.shutdown(cancel_futures=True)
    _progress("")
    proof.write()
    return proof.problems


def _progress(text: str) -> None:
    """On a terminal, one line that shows the progress of the proof."""
    if sys.stderr.isatty():
        print(f"\r\033[K{text[:78]}", end="", file=sys.stderr, flush=True)


class _Proof:
    def __init__(self, promela: dict[str, str], results: Path) -> None:
        self._tables = promela
        self._results = results
        self.problems: list[str] = []
        self._rows: dict[str, dict[int, tuple[str | float, ...]]] = {"": {}, "-mutants": {}, "-paper": {}, "-conformance": {}}

    def write(self) -> None:
        headers = {
            "": ("pair", "adapter", "properties", "scene", "states", "depth", "memory_mb", "holds"),
            "-mutants": ("mechanism", "mutant", "pair", "scene", "property", "steps", "states", "noticed", "picture"),
            "-paper": ("property", "pair", "scene", "states", "holds", "steps", "picture"),
            "-conformance": ("pair", "told", "traces", "inputs", "equal"),
        }
        for suffix, header in headers.items():
            table = Table(f"proof{suffix}", header)
            for _, row in sorted(self._rows[suffix].items()):
                table.add(*row)
            table.write(self._results)

    def searches(self) -> list[_Task]:
        return [
            self._search(number, pair, adapter, only, acts)
            for number, (pair, adapter, (only, acts)) in enumerate(
                (pair, adapter, scene) for pair in plan.PAIRS for adapter in plan.ADAPTERS for scene in plan.scenes(pair)
            )
        ]

    def _search(self, number: int, pair: Pair, adapter: plan.Adapter, only: str, acts: plan.Acts) -> _Task:
        def run() -> None:
            found = self._spin(f"search-{number}", pair, acts, adapter.definitions, only)
            what = only or "safety"
            row = (pair.name, adapter.name, what, plan.words(acts), found.states, found.depth, round(found.memory_mb))
            self._rows[""][number] = (*row, _yes(not found.broken))
            if found.broken:
                self.problems.append(f"{pair.name}, {plan.words(acts)}: {found.broken} does not hold")
                self._draw(f"violated-{number}", pair, found, "the design")

        return _Task(f"{pair.name}, {plan.words(acts)}", run)

    def mutants(self) -> list[_Task]:
        return [self._mutant(number, mutant) for number, mutant in enumerate(plan.MUTANTS)]

    def _mutant(self, number: int, mutant: plan.Mutant) -> _Task:
        def run() -> None:
            defined = (*mutant.adapter.definitions, f"-D{mutant.name}")
            found = self._spin(f"mutant-{number}", mutant.pair, mutant.acts, defined, mutant.broken)
            noticed = found.broken == mutant.broken
            name = mutant.name.lower().replace("_", "-")
            picture = self._draw(name, mutant.pair, found, f"without: {mutant.mechanism}") if noticed else ""
            if noticed and mutant.in_core:
                told = story.write(found.trail, sequence.Names.of(self._tables[mutant.pair.key]))
                (self._results / "proof" / f"{name}.txt").write_text(told, encoding="utf-8")
            row = (mutant.mechanism, mutant.name, mutant.pair.name, plan.words(mutant.acts), mutant.broken)
            self._rows["-mutants"][number] = (*row, sequence.steps(found.trail), found.states, _yes(noticed), picture)
            if not noticed:
                self.problems.append(f"{mutant.name} is not noticed: {mutant.broken} still holds")

        return _Task(mutant.name, run)

    def papers(self) -> list[_Task]:
        wanted = [(only, pair, acts) for only, acts in plan.PAPER for pair in plan.PAPERS_PAIRS]
        return [self._paper(number, *one) for number, one in enumerate(wanted)]

    def _paper(self, number: int, only: str, pair: Pair, acts: plan.Acts) -> _Task:
        def run() -> None:
            defined = (*plan.BEST.definitions, "-DPAPER", "-DNO_BACK_PRESSURE")
            found = self._spin(f"paper-{number}", pair, acts, defined, only)
            picture = self._draw(f"paper-{only}-{pair.key}", pair, found, "the paper's mechanism") if found.broken else ""
            row = (only, pair.name, plan.words(acts), found.states, _yes(not found.broken), sequence.steps(found.trail))
            self._rows["-paper"][number] = (*row, picture)

        return _Task(f"the paper's mechanism: {only}", run)

    def conformance(self) -> list[_Task]:
        told = (("random inputs", "script", _TRACES, script.compare), ("recorded runs", "runs", _RUNS, script.compare_runs))
        wanted = [(pair, *one) for pair in plan.PAIRS for one in told]
        return [self._conforms(number, *one) for number, one in enumerate(wanted)]

    def _conforms(self, number: int, pair: Pair, told: str, key: str, traces: int, compare: _Compare) -> _Task:
        def run() -> None:
            inputs, difference = compare(self._folder(f"{key}-{pair.key}"), pair, traces, 1)
            self._rows["-conformance"][number] = (pair.name, told, traces, inputs, _yes(not difference))
            if difference:
                self.problems.append(f"the core and the specification differ ({pair.name}, {told}):\n{difference}")

        return _Task(f"conformance, {pair.name}, {told}", run)

    def _folder(self, name: str) -> Path:
        return tables.ROOT / "target" / "proof" / name

    def _spin(self, name: str, pair: Pair, acts: plan.Acts, definitions: tuple[str, ...], only: str) -> Result:
        return spin.search(self._folder(name), self._tables[pair.key], acts, definitions, only)

    def _draw(self, name: str, pair: Pair, found: Result, title: str) -> str:
        folder = self._results / "proof"
        folder.mkdir(parents=True, exist_ok=True)
        picture = sequence.draw(found.trail, sequence.Names.of(self._tables[pair.key]), title, found.broken)
        (folder / f"{name}.svg").write_text(picture, encoding="utf-8")
        return f"proof/{name}.svg"


def _yes(holds: bool) -> str:
    return "yes" if holds else "NO"
