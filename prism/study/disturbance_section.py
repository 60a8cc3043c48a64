"""The section of the report on crashes, broken links, and replaced models."""

from study.curves import Curves
from study.disturbances import CAPACITY, OPERATED_PER_S, RESTART_S
from study.markdown import table
from study.paper import ARRIVALS_PER_S, HORIZON_S
from study.tables import Cell, Table

_COLUMNS = ("lost until 100 s", "completion in s", "mean wait in s")


def disturbances(curves: Curves, tables: dict[str, Table]) -> str:
    calm = (
        curves.lost("fifo-pipelined", HORIZON_S, conversion=0.25, K=CAPACITY),
        curves.completion_s("fifo-pipelined", conversion=0.25, K=CAPACITY),
    )
    return "\n\n".join(
        (
            f"""## 5. Crashes, broken links, other models

The pipelined converter (K={CAPACITY}, conversion 0.25 s) with disturbances. Without them it loses {calm[0]:.3g} of
{ARRIVALS_PER_S * HORIZON_S:g} events until 100 s and completes after {calm[1]:.1f} s. Times between disturbances and their durations are
exponential.""",
            _crashes(tables["crash"]),
            _sight(tables["sight"]),
            _swaps(tables["swap"]),
        )
    )


def _crashes(found: Table) -> str:
    by_key = {row[:3]: row[3:] for row in found.rows}
    rows = [
        (f"{every:g} s, {down:g} s", "yes" if journal else "no", *_three(row), row[5], f"{100 * float(row[6] or 0):.1f} %")
        for (journal, every, down), row in by_key.items()
    ]
    often, seldom = _saved(by_key, 20.0, 1.0), _saved(by_key, 60.0, 5.0)
    return f"""**Crashes** (`crash.sm`). The table gives the mean times to a crash and to the restart (a Roomba's converter takes 0.7 s
from its start to the first event). While no process runs, every event is lost, and the device finishes its action.

{table(("crash after, restart after", "journal", *_COLUMNS, "record wrong after s", "share of time"), rows)}

Without a journal, a wait that a crash cuts short is counted up to the crash. A journal cannot record events that arrive while no
process runs. It saves the waiting events: {often:.0f} % of the losses if the process restarts after 1 s, {seldom:.0f} % if it
restarts after 5 s. It also saves the record: without a journal the next process assumes that the device is in its initial state. From
the first restart on, that is wrong two thirds of the time while a process runs, unless the device can report its state. With a
journal it is never wrong. A restart after 1 s without a journal loses fewer events than one after 5 s with a journal: a fast restart
matters as much. These models do not show that a step may be in doubt after a crash, because sending takes no time in them; the proof
does (section 10)."""


def _saved(by_key: dict[tuple[Cell, ...], tuple[Cell, ...]], every: float, down: float) -> float:
    kept, gone = (float(by_key[journal, every, down][0] or 0) for journal in (1, 0))
    return 100 * (1 - kept / gone)


def _sight(found: Table) -> str:
    rows = [(f"{row[1]:g} s", *_three(row[3:]), f"{100 * float(row[9] or 0):.2g} %") for row in found.rows]
    return f"""**Broken links** (`sight.sm`). The link breaks every 60 s, and is restored after a while. Nothing can be sent meanwhile; events
wait. The last column is the share of time in which the record is wrong if the device is operated manually while it is unreachable,
every {1 / OPERATED_PER_S:g} s. The record is wrong only until the device is found: then it follows the device's state (`foundIn`).

{table(("unreachable for", *_COLUMNS, "record wrong"), rows)}

As long as the queue has room, a broken link costs time but no events. At {ARRIVALS_PER_S:g} events a second, {CAPACITY} places last for about
{CAPACITY / ARRIVALS_PER_S:g} s."""


def _swaps(found: Table) -> str:
    rows = [(f"{_way(row)}", *_three(row[3:])) for row in found.rows]
    return f"""**Other models** (`swap.sm`). Every {found.rows[0][1]:g} s other models take over: as soon as the event in the loop has ended;
no event begins until the takeover is complete. For comparison, the table has the cost of a restart with the other models, which takes {RESTART_S:g} s.

{table(("way", *_COLUMNS), rows)}

A swap itself loses no event; only a full queue does. During a swap, one event less can be held, because no event is in
the loop."""


def _way(row: tuple[Cell, ...]) -> str:
    return f"swap, {row[2]:g} s" if row[0] == "swap" else f"{row[0]}"


def _three(found: tuple[Cell, ...]) -> tuple[Cell, ...]:
    lost, _, completion, _, wait, *_ = found
    return lost, completion, wait
