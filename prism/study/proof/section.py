"""The section of the report on the proof."""

from study.markdown import table
from study.proof.plan import ADAPTERS
from study.tables import Cell, Table

TABLES = ("proof", "proof-mutants", "proof-paper", "proof-conformance")

Row = tuple[Cell, ...]


def proof(tables: dict[str, Table]) -> str:
    if any(name not in tables for name in TABLES):
        return """## 10. The design, proved

Not proved yet; `./evoloop study --proof` does."""
    searches, mutants, paper, conformance = (tables[name].rows for name in TABLES)
    return "\n\n".join(
        (
            "## 10. The design, proved",
            _what(searches),
            _searches(searches),
            _mutants(mutants),
            _paper(paper),
            _conformance(conformance),
        )
    )


def _what(searches: list[Row]) -> str:
    states = sum(int(row[4] or 0) for row in searches)
    failed = [row for row in searches if row[-1] != "yes"]
    verdict = f"**{len(failed)} of them fail.**" if failed else "All hold."
    adapters = "; ".join(f"*{adapter.name}*: {adapter.meaning}" for adapter in ADAPTERS)
    return f"""The specification in `prism/proof` (Promela) has the core's inputs, with the tables of the paper's two pairs, of a fan
whose boost needs the device somewhere, and of an elevator whose fire alarm is urgent, as `DecisionTable` compiles them from the
model files, and an environment: a device that acts by itself, its adapter, the loop, people, functions, timers, crashes,
swaps. [docs/proof.md](../../docs/proof.md) says what the properties mean, and lists the assumptions. Spin visits every
interleaving of each scene, without bitstate hashing.
{len(searches)} searches, {states:,} states: {verdict}

`drains` and `swaps` are about liveness, under weak fairness; `safety` is all others but `another`. That, and what `resumes` says
of a report that is not an answer, have searches of their own. Each scene is searched with two kinds of
device and adapter. {adapters}."""


def _searches(searches: list[Row]) -> str:
    """A row for each kind of search; proof.csv has each search."""
    kinds: dict[tuple[Cell, ...], list[Row]] = {}
    for search in searches:
        kinds.setdefault(search[:3], []).append(search)
    rows = [
        (
            *kind,
            len(found),
            f"{sum(int(states or 0) for *_, states, _, _, _ in found):,}",
            max(int(depth or 0) for *_, depth, _, _ in found),
            f"{max(int(memory or 0) for *_, memory, _ in found)} MB",
            "yes" if all(search[-1] == "yes" for search in found) else "**no**",
        )
        for kind, found in kinds.items()
    ]
    return "### Searches\n\n" + table(
        ("pair", "adapter", "properties", "scenes", "states", "deepest", "most memory", "hold"), rows
    )


def _mutants(mutants: list[Row]) -> str:
    rows = [
        (
            f"{mechanism} (`{name}`)",
            pair,
            scene,
            f"`{broken}`",
            steps if noticed == "yes" else "**not noticed**",
            f"[trail]({picture})" if picture else "",
        )
        for mechanism, name, pair, scene, broken, steps, _, noticed, picture in mutants
    ]
    return f"""### Each property fails without its mechanism

{table(("removed mechanism", "pair", "scene", "fails", "after steps", "story"), rows)}"""


def _paper(paper: list[Row]) -> str:
    rows = [
        (f"`{key}`", pair, scene, holds, steps or "", f"[trail]({picture})" if picture else "")
        for key, pair, scene, _, holds, steps, picture in paper
    ]
    return f"""### The paper's mechanism under the same specification

Algorithm 1 and the converter of the paper's listing in the same environment, with the best adapter: one event at a time, events that
arrive meanwhile are lost, the original model moves by the incoming event, and no state survives the process.

{table(("property", "pair", "scene", "holds", "fails after steps", "story"), rows)}"""


def _conformance(conformance: list[Row]) -> str:
    rows = [(pair, told, traces, f"{inputs:,}", equal) for pair, told, traces, inputs, equal in conformance]
    return f"""### The code and the specification

The real core (`org.evoloop.engine.Core`) and the specification get the same random inputs, in any order; after each, their complete
states are compared: record, doubt, visit, plan, and every waiting occurrence. The same is done with the inputs in the journals of
runs of the whole converter, with its threads: events of a controller, actions of the device, steps that fail or whose effect is
unknown, timers, stops, crashes and swaps.

{table(("pair", "source", "traces", "inputs", "all equal"), rows)}"""
