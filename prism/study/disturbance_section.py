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
            f"""## 5. Crashes, links that break, other models

The pipelined converter (K={CAPACITY}, conversion 0.25 s) when more happens than events. Undisturbed it loses {calm[0]:.3g} of
{ARRIVALS_PER_S * HORIZON_S:g} events until 100 s and completes after {calm[1]:.1f} s. Times between disturbances and their lengths are
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
    return f"""**Crashes** (`crash.sm`). The process ends so often, and is started again so long after (a Roomba's converter takes 0.7 s
from its start to the first event). While none runs, every event is lost, and the device goes on with its action.

{table(("a crash after, back after", "journal", *_COLUMNS, "record wrong after s", "share of time"), rows)}

Without a journal, waits that a crash cuts off count as far as they went. A journal cannot hear what comes while nobody listens. It saves what waits: {often:.0f} % of the losses where the process is back after
1 s, {seldom:.0f} % where that takes 5 s. And it saves the record: without one the next process takes the device to be
where it was initially. From the first restart on, that is wrong two times of three while a process runs, unless the device can say
where it is. With a journal it is never wrong. Back in 1 s without a journal loses fewer than back in 5 s with one: how soon the process
is started again matters as much. That a step may be in doubt after a crash does not show here, because sending takes no time in these models;
the proof has that (section 10)."""


def _saved(by_key: dict[tuple[Cell, ...], tuple[Cell, ...]], every: float, down: float) -> float:
    kept, gone = (float(by_key[journal, every, down][0] or 0) for journal in (1, 0))
    return 100 * (1 - kept / gone)


def _sight(found: Table) -> str:
    rows = [(f"{row[1]:g} s", *_three(row[3:]), f"{100 * float(row[9] or 0):.2g} %") for row in found.rows]
    return f"""**Out of sight** (`sight.sm`). The link breaks every 60 s, and is found again after a while. Nothing can be sent meanwhile; events
wait. The last column is the share of time in which the record is wrong if somebody operates the device by hand while it is out
of sight, every {1 / OPERATED_PER_S:g} s. It never is for longer than that: where the device is found, the record goes (`foundIn`).

{table(("out of sight for", *_COLUMNS, "record wrong"), rows)}

As long as the queue has room, a link that breaks costs time and no events. At {ARRIVALS_PER_S:g} events a second {CAPACITY} places last for some
{CAPACITY / ARRIVALS_PER_S:g} s."""


def _swaps(found: Table) -> str:
    rows = [(f"{_way(row)}", *_three(row[3:])) for row in found.rows]
    return f"""**Other models** (`swap.sm`). Every {found.rows[0][1]:g} s other models take over: as soon as the event in the loop has come to its end, and
no event begins until they have. Beside it, what it costs to start the process again with them instead, which takes {RESTART_S:g} s.

{table(("way", *_COLUMNS), rows)}

No swap loses an event by itself; only a queue that is full does. While models take over, one event less can be held, because no event is in
the loop."""


def _way(row: tuple[Cell, ...]) -> str:
    return f"swap, {row[2]:g} s" if row[0] == "swap" else f"{row[0]}"


def _three(found: tuple[Cell, ...]) -> tuple[Cell, ...]:
    lost, _, completion, _, wait, *_ = found
    return lost, completion, wait
